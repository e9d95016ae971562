#include "core/accumulate/horizon/period_count.h"

#include <tbb/parallel_for.h>

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

void forEachCell(const ReceiverBlocks& blocks, std::size_t part, const auto& visit) {
    const std::size_t first = part * lanesARun, end = std::min(first + lanesARun, blocks.numbers());
    for (std::size_t number = first; number < end; ++number)
        if (const std::uint32_t cell = blocks.cell(number); cell != ReceiverBlocks::padding)
            visit(number, cell);
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

void PeriodCount::addHidden(std::size_t bin, std::span<const Gap> gaps, std::span<std::uint32_t> sums) const {
    for (const Gap& gap : gaps) sums[gap.number] += hidden_[bin](gap.high) - hidden_[bin](gap.low);
}

void PeriodCount::writeOpenRuns(const ReceiverBlocks& blocks, const BinCodes& codes,
                                const std::vector<std::vector<Gap>>& gaps, ShadowField& field,
                                const std::stop_token& stop) const {
    std::vector<std::uint32_t> numbers;
    for (const auto& bin : gaps)
        for (const Gap& gap : bin) numbers.push_back(gap.number);
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    tbb::parallel_for(std::size_t{0}, numbers.size(), [&](std::size_t i) {
        if (stop.stop_requested()) return;
        const std::uint32_t number = numbers[i];
        std::vector<std::span<const Gap>> own;
        for (const auto& bin : gaps) own.push_back(gapsOf(number, bin));
        const int longest = runs_.ofOne([&](const StepPlace& place) {
            return codes[place.bin][number] > place.sun ||
                   std::ranges::any_of(own[place.bin], [&](const Gap& gap) {
                       return gap.low <= place.sun && place.sun < gap.high;
                   });
        });
        field.continuousMin[blocks.cell(number)] = float(longest * field.stepMinutes);
    });
}

RunLanes PeriodCount::longestRuns(const BinCodes& codes, std::size_t part,
                                  std::vector<RunLanes>& lanes) const {
    copyLanes(codes, part * lanesARun, lanes);
    return runs_.of(lanes);
}

void writeGross(const ReceiverBlocks& blocks, std::size_t part, std::span<const std::uint32_t> hidden,
                ShadowField& field) {
    forEachCell(blocks, part, [&](std::size_t number, std::uint32_t cell) {
        field.grossMin[cell] = float(double(hidden[number]) * field.stepMinutes / field.days);
    });
}

void writeRuns(const ReceiverBlocks& blocks, std::size_t part, const RunLanes& longest, ShadowField& field) {
    forEachCell(blocks, part, [&](std::size_t number, std::uint32_t cell) {
        field.continuousMin[cell] = float(longest.values[number % lanesARun] * field.stepMinutes);
    });
}

void writeMinutes(const ReceiverBlocks& blocks, std::size_t part, std::span<const std::uint32_t> hidden,
                  const RunLanes& longest, ShadowField& field) {
    writeGross(blocks, part, hidden, field);
    writeRuns(blocks, part, longest, field);
}

}  // namespace noonmark
