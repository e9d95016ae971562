#include "core/accumulate/horizon/tile_horizons.h"

#include <algorithm>

namespace noonmark {

TileHorizons::TileHorizons(std::size_t bins, std::size_t numbers)
    : numbers_(numbers), codes_(std::make_unique_for_overwrite<HorizonCode[]>(bins * numbers)) {}

void copyLanes(std::span<const std::span<const HorizonCode>> bins, std::size_t first,
               std::vector<RunLanes>& lanes) {
    lanes.resize(bins.size());
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
        const std::size_t count = std::min(lanesARun, bins[bin].size() - first);
        const HorizonCode* from = bins[bin].data() + first;
        std::copy(from, from + count, lanes[bin].values);
        std::fill(lanes[bin].values + count, lanes[bin].values + lanesARun, noHorizon);
    }
}

}  // namespace noonmark
