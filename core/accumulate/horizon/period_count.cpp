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

// Gaps that begin at the horizon raise it; the others are listed, bin by bin.
void addGaps(const BinGaps& gaps, std::size_t first, RunMemory& memory) {
    memory.open.clear();
    for (std::size_t bin = 0; bin < gaps.size(); ++bin) {
        const auto from = std::ranges::lower_bound(gaps[bin], first, {}, &Gap::number);
        const auto end = std::ranges::lower_bound(from, gaps[bin].end(), first + lanesARun, {}, &Gap::number);
        forEachReceiver(std::span<const Gap>(from, end), [&](std::span<const Gap> own) {
            const auto lane = std::uint32_t(own.front().number - first);
            HorizonCode& horizon = memory.lanes[bin].values[lane];
            forEachAdded(horizon, own, [&](const Gap& gap, HorizonCode low) {
                if (low == horizon)
                    horizon = gap.high;
                else
                    memory.open.push_back({std::uint16_t(bin), {lane, low, gap.high}});
            });
        });
    }
}

// `open`: by lane.
void forEachLane(std::span<const OpenGap> open, const auto& visit) {
    for (std::size_t first = 0, end = 0; first < open.size(); first = end) {
        while (end < open.size() && open[end].gap.number == open[first].gap.number) ++end;
        visit(open[first].gap.number, open.subspan(first, end - first));
    }
}

// `own`: by bin.
void setBins(std::span<const OpenGap> own, std::vector<std::span<const OpenGap>>& ofBin) {
    std::ranges::fill(ofBin, std::span<const OpenGap>());
    for (std::size_t first = 0, end = 0; first < own.size(); first = end) {
        while (end < own.size() && own[end].bin == own[first].bin) ++end;
        ofBin[own[first].bin] = own.subspan(first, end - first);
    }
}

RunCount runsOf(const SunSteps& sun, const BinnedSun& binned) {
    std::vector<TimedStep> steps = timedSteps(sun, binned);
    const std::vector<DaySteps> days = alikeDays(sun, steps);
    return {std::move(steps), days};
}

std::uint64_t laneBit(std::size_t lane) { return std::uint64_t{1} << lane; }

void forEachCell(const ReceiverBlocks& blocks, std::size_t part, const auto& visit) {
    const std::size_t first = part * lanesARun, end = std::min(first + lanesARun, blocks.numbers());
    for (std::size_t number = first; number < end; ++number)
        if (const std::uint32_t cell = blocks.cell(number); cell != ReceiverBlocks::padding)
            visit(number, cell);
}

}  // namespace

PeriodCount::PeriodCount(const SunSteps& sun, const BinnedSun& binned, const Wanted& wanted)
    : suns_(binned.bins.size()) {
    if (wanted.runs) runs_ = runsOf(sun, binned);
    tbb::parallel_for(std::size_t{0}, suns_.size(),
                      [&](std::size_t bin) { suns_[bin] = sunChanges(binned.bins[bin].suns, {}); });
    for (const AzimuthBin& bin : binned.bins)
        if (wanted.gaps) hidden_.emplace_back(bin.suns);
}

RunLanes RunCount::longestRuns(const BinCodes& codes, const BinGaps& gaps, std::size_t part,
                               RunMemory& memory) const {
    read(codes, gaps, part, memory);
    RunLanes longest = runs_.of(memory.lanes).longest;
    if (!memory.open.empty()) walkOpen(memory, longest);
    return longest;
}

RunLanes RunCount::decidedRuns(const BinCodes& codes, const BinGaps& gaps, std::size_t part,
                               const RunDecider& decider, std::uint64_t lanes, RunMemory& memory) const {
    read(codes, gaps, part, memory);
    LongestRuns::Found found = runs_.of(memory.lanes);
    for (const OpenGap& open : memory.open) lanes &= ~laneBit(open.gap.number);
    decider.decide(runs_, memory.lanes, part, lanes, found, memory.deciding);
    if (!memory.open.empty()) walkOpen(memory, found.longest);
    return found.longest;
}

void RunCount::read(const BinCodes& codes, const BinGaps& gaps, std::size_t part, RunMemory& memory) {
    copyLanes(codes, part * lanesARun, memory.lanes);
    addGaps(gaps, part * lanesARun, memory);
}

// Were all below the gaps hidden too, runs would be no shorter: where that changes nothing, gaps do not.
void RunCount::walkOpen(RunMemory& memory, RunLanes& longest) const {
    std::vector<RunLanes> filled = memory.lanes;
    for (const auto& [bin, gap] : memory.open)
        filled[bin].values[gap.number] = std::max(filled[bin].values[gap.number], gap.high);
    const RunLanes most = runs_.of(filled).longest;
    std::ranges::stable_sort(memory.open, {}, [](const OpenGap& open) { return open.gap.number; });
    std::vector<std::span<const OpenGap>> ofBin(memory.lanes.size());
    forEachLane(memory.open, [&](std::size_t lane, std::span<const OpenGap> own) {
        if (most.values[lane] == longest.values[lane]) return;
        setBins(own, ofBin);
        longest.values[lane] = std::int16_t(runs_.ofOne([&](const StepPlace& place) {
            return memory.lanes[place.bin].values[lane] > place.sun ||
                   std::ranges::any_of(ofBin[place.bin], [&](const OpenGap& open) {
                       return open.gap.low <= place.sun && place.sun < open.gap.high;
                   });
        }));
    });
}

std::uint64_t receiverLanes(const ReceiverBlocks& blocks, std::size_t part) {
    std::uint64_t lanes = 0;
    forEachCell(blocks, part,
                [&](std::size_t number, std::uint32_t) { lanes |= laneBit(number % lanesARun); });
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
        field.continuousMin[cell] = float(longest.values[number % lanesARun] * field.stepMinutes);
    });
}

}  // namespace noonmark
