#include "core/engines/points/horizons/bin_directions.h"

#include <cmath>

#include "core/engines/points/seen_edge.h"

namespace noonmark {

BinDirections::BinDirections(const SunBins& suns) {
    for (int bin = 0; bin < SunBins::count; ++bin) {
        const auto k = std::size_t(bin);
        exactSine[k] = std::sin((bin + 0.5) * fullTurn / SunBins::count);
        exactCosine[k] = std::cos((bin + 0.5) * fullTurn / SunBins::count);
        sine[k] = float(exactSine[k]);
        cosine[k] = float(exactCosine[k]);
        highestTan[k] = suns.bins[k].highestTan;
    }
}

}  // namespace noonmark
