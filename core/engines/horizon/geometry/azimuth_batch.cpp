#include "core/engines/horizon/geometry/azimuth_batch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace noonmark {

namespace {

// Largest difference of k. In wider batches walls are searched less often, but more of the walls found matter
// to no azimuth of a block.
constexpr double widest = 0.06;

bool alike(const ShadowAxes& a, const ShadowAxes& b) {
    return a.swapped == b.swapped && a.sign == b.sign && std::abs(a.k - b.k) <= widest;
}

// The axes of the middle azimuth.
ShadowAxes between(const ShadowAxes& a, const ShadowAxes& b) {
    if (a.k == b.k) return a;
    const double k = (a.k + b.k) / 2;
    return ShadowAxes((a.swapped ? glm::dvec2(a.sign, k) : glm::dvec2(k, a.sign)) / std::hypot(k, 1.0));
}

}  // namespace

std::vector<SweptBin> makeSweptBins(std::span<const AzimuthBin> bins) {
    std::vector<SweptBin> swept;
    for (const AzimuthBin& bin : bins) swept.push_back({bin.away, bin.lowest()});
    return swept;
}

std::vector<BatchRange> groupIntoBatches(std::span<const SweptBin> bins) {
    std::vector<BatchRange> batches;
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
        const bool more = !batches.empty() && batches.back().size() < std::size_t(BatchLanes::maximum) &&
                          alike(ShadowAxes(bins[batches.back().first].away), ShadowAxes(bins[bin].away));
        if (!more) batches.push_back({bin, bin});
        batches.back().end = bin + 1;
    }
    return batches;
}

BatchLanes::BatchLanes(std::span<const SweptBin> bins, double cellM)
    : count(int(bins.size())), batch{between(ShadowAxes(bins.front().away), ShadowAxes(bins.back().away))} {
    constexpr double rounding = 1e-3, side = ReceiverBlocks::side;
    for (int lane = 0; lane < maximum; ++lane) {
        const SweptBin& bin = bins[std::size_t(std::min(lane, count - 1))];
        const ShadowAxes axes(bin.away);
        const double shift = -axes.k * axes.sign * (side - 1),
                     ofMiddle = axes.alongPerDistance / batch.axes.alongPerDistance;
        k[lane] = axes.k;
        alongPerMetre[lane] = axes.alongPerDistance / cellM;
        riseOfMiddle[lane] = float(ofMiddle);
        minOff[lane] = float(std::min(0.0, shift) - rounding);
        maxOff[lane] = float(side - 1 + std::max(0.0, shift) + rounding);
        cotOfLowest[lane] = lane < count ? toCotangent(bin.lowest) : -std::numeric_limits<float>::infinity();
        batch.spread = std::max(batch.spread, std::abs(axes.k - batch.axes.k));
        const double tan = 1 / (ofMiddle * double(toCotangent(bin.lowest)));
        lowestTan = lane == 0 ? float(tan) : std::min(lowestTan, float(tan));
    }
}

}  // namespace noonmark
