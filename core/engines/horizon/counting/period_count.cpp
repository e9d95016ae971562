#include "core/engines/horizon/counting/period_count.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace noonmark {

namespace {

// Lanes beyond the last number get noHorizon.
void copyLanes(const BinCodes& codes, std::size_t first, std::vector<RunLanes>& lanes) {
    lanes.resize(codes.size());
    for (std::size_t bin = 0; bin < codes.size(); ++bin) {
        const std::size_t count = std::min(lanesPerPart, codes[bin].size() - first);
        const HorizonCode* from = codes[bin].data() + first;
        std::copy(from, from + count, lanes[bin].values);
        std::fill(lanes[bin].values + count, lanes[bin].values + lanesPerPart, noHorizon);
    }
}

// Gaps that begin at the horizon raise it; the others are listed by bin.
void addGaps(const BinGaps& gaps, std::size_t first, RunMemory& memory) {
    memory.overhangs.clear();
    for (std::size_t bin = 0; bin < gaps.size(); ++bin) {
        const auto from = std::ranges::lower_bound(gaps[bin], first, {}, &Gap::number);
        const auto end =
            std::ranges::lower_bound(from, gaps[bin].end(), first + lanesPerPart, {}, &Gap::number);
        forEachReceiver(std::span<const Gap>(from, end), [&](std::span<const Gap> own) {
            const auto lane = std::uint32_t(own.front().number - first);
            HorizonCode& horizon = memory.lanes[bin].values[lane];
            forEachAdded(horizon, own, [&](const Gap& gap, HorizonCode low) {
                if (low == horizon)
                    horizon = gap.high;
                else
                    memory.overhangs.push_back({std::uint16_t(bin), {lane, low, gap.high}});
            });
        });
    }
}

RunCount measureRuns(const SunSteps& sun, const BinnedSun& binned) {
    return RunCount(makeTimedSteps(sun, binned));
}

std::uint64_t laneBit(std::size_t lane) { return std::uint64_t{1} << lane; }

void forEachCell(const ReceiverBlocks& blocks, std::size_t part, const auto& visit) {
    const std::size_t first = part * lanesPerPart, end = std::min(first + lanesPerPart, blocks.numbers());
    for (std::size_t number = first; number < end; ++number)
        if (const std::uint32_t cell = blocks.cell(number); cell != ReceiverBlocks::padding)
            visit(number, cell);
}

}  // namespace

void listByBin(std::span<const OverhangGap> own, std::size_t bins, GapsByBin& ofBin) {
    ofBin.assign(bins, {});
    for (std::size_t first = 0, end = 0; first < own.size(); first = end) {
        while (end < own.size() && own[end].bin == own[first].bin) ++end;
        ofBin[own[first].bin] = own.subspan(first, end - first);
    }
}

PeriodCount::PeriodCount(const SunSteps& sun, const BinnedSun& binned, ShadowCounts counts)
    : suns_(binned.bins.size()) {
    if (counts == ShadowCounts::grossAndRuns) runs_ = measureRuns(sun, binned);
    tbb::parallel_for(std::size_t{0}, suns_.size(),
                      [&](std::size_t bin) { suns_[bin] = findSunChanges(binned.bins[bin].suns, {}); });
}

RunLanes RunCount::longestRuns(const BinCodes& codes, const BinGaps& gaps, std::size_t part,
                               RunMemory& memory) const {
    read(codes, gaps, part, memory);
    return find(memory).found.longest;
}

RunLanes RunCount::decidedRuns(const BinCodes& codes, const BinGaps& gaps, std::size_t part,
                               const RunDecider& decider, std::uint64_t lanes, RunMemory& memory) const {
    read(codes, gaps, part, memory);
    PartRuns runs = find(memory);
    decider.decide(runs_, part, lanes, runs, memory.deciding);
    return runs.found.longest;
}

PartRuns RunCount::find(RunMemory& memory) const {
    PartRuns runs{memory.lanes, memory.lanes, runs_.of(memory.lanes)};
    if (!memory.overhangs.empty()) walkWithOverhangs(memory, runs);
    memory.undecided = runs.found.longest;
    return runs;
}

void RunCount::read(const BinCodes& codes, const BinGaps& gaps, std::size_t part, RunMemory& memory) {
    copyLanes(codes, part * lanesPerPart, memory.lanes);
    addGaps(gaps, part * lanesPerPart, memory);
}

// Filling the space below the gaps can only lengthen runs. Where it changes nothing, the gaps have no effect.
void RunCount::walkWithOverhangs(RunMemory& memory, PartRuns& runs) const {
    memory.filled = memory.lanes;
    for (const auto& [bin, gap] : memory.overhangs) {
        HorizonCode& horizon = memory.filled[bin].values[gap.number];
        horizon = std::max(horizon, gap.high);
    }
    runs.filled = memory.filled;
    RunLanes& longest = runs.found.longest;
    const RunLanes maximum = runs_.of(memory.filled).longest;
    std::ranges::stable_sort(memory.overhangs, {},
                             [](const OverhangGap& overhangs) { return overhangs.gap.number; });
    forEachLane(memory.overhangs, [&](std::size_t lane, std::span<const OverhangGap> own) {
        if (maximum.values[lane] == longest.values[lane]) return;
        listByBin(own, memory.lanes.size(), memory.gaps);
        runs.below[lane] = runs_.ofOne([&](const StepPlace& place) {
            return memory.lanes[place.bin].values[lane] > place.sun ||
                   isInGap(memory.gaps[place.bin], place.sun);
        });
        longest.values[lane] = std::int16_t(runs.below[lane].length());
    });
}

std::uint64_t findReceiverLanes(const ReceiverBlocks& blocks, std::size_t part) {
    std::uint64_t lanes = 0;
    forEachCell(blocks, part,
                [&](std::size_t number, std::uint32_t) { lanes |= laneBit(number % lanesPerPart); });
    return lanes;
}

void writeGross(const ReceiverBlocks& blocks, std::size_t part, std::span<const std::uint32_t> hidden,
                ShadowField& field) {
    forEachCell(blocks, part, [&](std::size_t number, std::uint32_t cell) {
        field.grossMin[cell] = float(double(hidden[number]) * field.stepMinutes / field.days);
    });
}

void writeRuns(const ReceiverBlocks& blocks, std::size_t part, const RunLanes& longest, ShadowField& field) {
    forEachCell(blocks, part, [&](std::size_t number, std::uint32_t cell) {
        field.continuousMin[cell] = float(longest.values[number % lanesPerPart] * field.stepMinutes);
    });
}

}  // namespace noonmark
