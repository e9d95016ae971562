#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "app/report/maps/legend_painter.h"
#include "render/scene/element_tiles.h"

namespace noonmark {

/// Coloured tiles that the view shows instead of a result, with their legend and what is told of each.
struct TileView {
    std::vector<ElementTiles::Tile> tiles;
    Legend legend;  ///< in English, as files have it
    std::function<QString(std::size_t tile)> describe;
};

}  // namespace noonmark
