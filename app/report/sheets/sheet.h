#pragma once

#include <QIODevice>
#include <QImage>
#include <optional>
#include <vector>

#include "app/report/maps/map_painter.h"
#include "app/report/sheets/headline.h"
#include "app/report/sheets/study_words.h"
#include "app/report/sheets/text_column.h"

namespace noonmark {

/// A map with its legend.
struct SheetMap {
    MapScene scene;
    Legend legend;
};

/// One page about one answer: a study, a comparison or a score. Holds no answer: what its maps look at
/// outlives it.
struct Sheet {
    Headline headline;
    SheetMap map;
    TextBlocks definitions{};            ///< what the numbers mean, below the map
    std::optional<SheetMap> smallMap{};  ///< of another measure, above the figures
    std::vector<Figure> figures{};       ///< the first one in bold
    std::vector<TextBlocks> sections{};  ///< two or more; each begins with its heading and stays whole
    TextBlocks repeat{};                 ///< across the page at the bottom; none: nothing
    QString credit{};                    ///< whose data it is
};

/// An A4 page. False where the device did not take it.
bool writePdf(const Sheet& sheet, QIODevice& device);

constexpr int pictureWidth = 1600;

/// For the screen and for slides, pictureWidth wide: title, map, legend, scale bar, north arrow, whose data
/// it is. As high as the region's shape asks for.
QImage makePicture(const Sheet& sheet);

}  // namespace noonmark
