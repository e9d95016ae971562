#pragma once

#include "app/report/book/book.h"
#include "core/city/building_heights.h"
#include "core/study/elements/place_elements.h"

namespace noonmark {

/// A building whose sides are drawn.
struct ElevationBuilding {
    QString name;
    const Building* building = nullptr;             ///< null: windows at no building
    std::vector<ElevationPane> panes;               ///< its windows
    std::vector<std::vector<ElevationCell>> cells;  ///< by panel, then by pane; a panel may be empty
    std::vector<QString> notes;                     ///< by panel: why it is empty
    double storeyM = defaultStoreyM;                ///< between the floors that are drawn
};

/// "Floors of 3.5 m", and that designed towers have their own.
QString describeFloors(const ElementSettings& elements);

/// Pages of elevations in a book: the rest of it has some ten.
inline std::size_t maxSidePages(const BookSettings& settings) { return settings.allPages ? 40 : 18; }

/// What all pages of elevations of a book share.
struct ElevationSheets {
    QString title, subtitle;
    QString bookmark;
    std::vector<QString> panels;  ///< titles: "Baseline", "Scenario", "Change"
    ElevationFoot foot;
    Frame frame;  ///< of the city, for azimuths from true north
    std::size_t maxPages = 18;
    std::optional<double> scale{};  ///< 1:scale, of all sides that fit on a page at it; none: chosen for each
};

/// Each side of each building, in their order, at the largest round scale of its strip: a third, half or all
/// of a page, so that a metre has at least 4 points of paper where it can; or at `scale`. A side that does
/// not fit at that scale has the largest that fits; its caption and the first page state it. What exceeds
/// `maxPages` is left out, and the subtitle of the first page states how many buildings. Buildings must
/// outlive the call only.
std::vector<BookPage> makeElevationPages(const PageSetup& setup, ElevationSheets sheets,
                                         const std::vector<ElevationBuilding>& buildings);

}  // namespace noonmark
