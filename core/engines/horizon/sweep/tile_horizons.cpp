#include "core/engines/horizon/sweep/tile_horizons.h"

namespace noonmark {

// The codes take hundreds of megabytes; they are written once, bin by bin, and read across bins. With huge
// pages, reading across bins moves only a page or two from one bin to the next.
TileHorizons::TileHorizons(std::size_t bins, std::size_t numbers)
    : numbers_(numbers),
      codes_(static_cast<HorizonCode*>(allocateHugePages(bins * numbers * sizeof(HorizonCode)))) {}

}  // namespace noonmark
