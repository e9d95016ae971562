#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include "app/report/maps/answer_legends.h"
#include "app/report/maps/legend_painter.h"
#include "render/scene/element_tiles.h"

namespace noonmark {

/// Coloured tiles that the view shows instead of a result, with their legend and what is told of each.
struct TileView {
    std::vector<ElementTiles::Tile> tiles;
    Legend legend;  ///< in English, as files have it
    std::function<QString(std::size_t tile)> describe;
};

/// What the view shows of points, and the note beside the legend.
struct ElementView {
    std::shared_ptr<const ElementMap> map;  ///< not null
    QString note;
    bool marked = false;  ///< the note is a warning
    /// Instead of the note while continuous shadow is shown; empty: the note holds for both measures.
    QString runNote{};
};

/// A rectangle for each element, in their order. Those that the scale leaves free
/// have the colour of 0.
std::vector<ElementTiles::Tile> makeTiles(const ElementMap& map, ShadowMeasure measure,
                                          const ColourScale& scale);

/// "floor 3, 4.2 h of sun a day, at most 3.1 h without a break, gross 90.0 min a day, continuous 45.0 min".
QString describe(const MeasuredElement& element);

}  // namespace noonmark
