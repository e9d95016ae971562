#pragma once

#include <QSizeF>
#include <memory>
#include <optional>
#include <vector>

#include "app/report/book/page_text.h"
#include "app/report/maps/legend_painter.h"
#include "core/city/building_heights.h"
#include "core/receivers/points/facade_elevations.h"

namespace noonmark {

enum class ElevationMark { none, fail, borderline, worse, better };

/// What a panel shows of a window.
struct ElevationCell {
    QColor colour;
    ElevationMark mark = ElevationMark::none;
};

/// One picture of an elevation: the baseline, the scenario, or the change.
struct ElevationPanel {
    QString title;
    std::vector<ElevationCell> cells;  ///< by window of the elevation; empty: `note` instead of a picture
    QString note{};
};

/// How the panels of an elevation are placed and scaled.
struct ElevationLayout {
    bool stacked = false;  ///< one below the other, else side by side
    double scale = 500;    ///< 1:scale on paper
};

/// A side of a building to scale, once for each panel, with its caption above.
struct ElevationDrawing {
    std::shared_ptr<const FacadeElevation> elevation;  ///< not null
    std::vector<ElevationPanel> panels;
    ElevationLayout layout;
    double storeyM = defaultStoreyM;
    Caption caption;
    double textScale = 1;
};

/// The legends of the elevations above it: values, change, marks.
struct ElevationFoot {
    std::vector<Legend> legends;
    bool hasMarks = true;
    QString note{};
    double textScale = 1;
};
constexpr double elevationFootPt(double scale) { return 58 * scale; }

/// The layout that shows an elevation of that size (metres) at the largest round scale in so many panels
/// within an area (points); none if even 1:20000 does not fit.
std::optional<ElevationLayout> fitElevation(glm::dvec2 sizeM, std::size_t panels, const QSizeF& areaPt,
                                            double textScale);

/// The height that an elevation takes in that layout, points.
double elevationHeightPt(glm::dvec2 sizeM, std::size_t panels, const ElevationLayout& layout,
                         double textScale);

void paintElevation(const Canvas& canvas, const QRectF& area, const ElevationDrawing& drawing);
void paintElevationFoot(const Canvas& canvas, const QRectF& area, const ElevationFoot& foot);

/// The layout that shows an elevation of that size (metres) at that scale in so many panels within an area
/// (points); none if it does not fit.
std::optional<ElevationLayout> fitElevationAt(glm::dvec2 sizeM, std::size_t panels, const QSizeF& areaPt,
                                              double textScale, double scale);

}  // namespace noonmark
