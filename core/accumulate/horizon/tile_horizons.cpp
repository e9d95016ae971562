#include "core/accumulate/horizon/tile_horizons.h"

namespace noonmark {

TileHorizons::TileHorizons(std::size_t bins, std::size_t numbers)
    : numbers_(numbers), codes_(std::make_unique_for_overwrite<HorizonCode[]>(bins * numbers)) {}

}  // namespace noonmark
