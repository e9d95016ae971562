#include "core/accumulate/horizon/period_count.h"

#include <algorithm>

namespace noonmark {

namespace {

// Beyond the last number noHorizon.
void copyLanes(const BinCodes& codes, std::size_t first, std::vector<RunLanes>& lanes) {
    lanes.resize(codes.size());
    for (std::size_t bin = 0; bin < codes.size(); ++bin) {
        const std::size_t count = std::min(lanesARun, codes[bin].size() - first);
        const HorizonCode* from = codes[bin].data() + first;
        std::copy(from, from + count, lanes[bin].values);
        std::fill(lanes[bin].values + count, lanes[bin].values + lanesARun, noHorizon);
    }
}

}  // namespace

PeriodCount::PeriodCount(const SunSteps& sun, const BinnedSun& binned) : runs_(timedSteps(sun, binned)) {
    for (const AzimuthBin& bin : binned.bins) hidden_.emplace_back(bin.suns);
}

void PeriodCount::addHidden(std::size_t bin, std::span<const HorizonCode> codes,
                            std::span<std::uint32_t> sums) const {
    const HiddenSuns& hidden = hidden_[bin];
    for (std::size_t i = 0; i < codes.size(); ++i) sums[i] += hidden(codes[i]);
}

RunLanes PeriodCount::longestRuns(const BinCodes& codes, std::size_t part,
                                  std::vector<RunLanes>& lanes) const {
    copyLanes(codes, part * lanesARun, lanes);
    return runs_.of(lanes);
}

void writeMinutes(const ReceiverBlocks& blocks, std::size_t part, std::span<const std::uint32_t> hidden,
                  const RunLanes& longest, ShadowField& field) {
    const std::size_t first = part * lanesARun, end = std::min(first + lanesARun, blocks.numbers());
    for (std::size_t i = first; i < end; ++i)
        if (const std::uint32_t cell = blocks.cell(i); cell != ReceiverBlocks::padding) {
            field.grossMin[cell] = float(double(hidden[i]) * field.stepMinutes / field.days);
            field.continuousMin[cell] = float(longest.values[i - first] * field.stepMinutes);
        }
}

}  // namespace noonmark
