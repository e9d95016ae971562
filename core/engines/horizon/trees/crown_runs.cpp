#include "core/engines/horizon/trees/crown_runs.h"

#include <algorithm>
#include <array>
#include <limits>

namespace noonmark {

namespace {

constexpr std::size_t halfPart = lanesPerPart / 2;

std::size_t paddedCount(const ReceiverBlocks::Block& block) {
    return (block.count + halfPart - 1) / halfPart * halfPart;
}

}  // namespace

void CrownMarks::begin(std::size_t bins, const ReceiverBlocks& blocks) {
    blocks_ = &blocks;
    entries_.clear();
    entries_.resize(bins * blocks.blocks().size());
    blockOfHalf_.assign(blocks.numbers() / halfPart, 0);
    for (std::size_t i = 0; i < blocks.blocks().size(); ++i) {
        const ReceiverBlocks::Block& block = blocks.blocks()[i];
        std::fill_n(blockOfHalf_.begin() + std::ptrdiff_t(block.first / halfPart),
                    paddedCount(block) / halfPart, std::uint32_t(i));
    }
}

std::unique_ptr<DarkLevels[]> CrownMarks::copyMarks(std::size_t block, bool swapped,
                                                    const DarkLevels* of) const {
    const ReceiverBlocks::Block& own = blocks_->blocks()[block];
    const std::uint8_t* places = blocks_->places(own, swapped);
    auto levels = std::make_unique<DarkLevels[]>(paddedCount(own));
    for (std::uint32_t i = 0; i < own.count; ++i) levels[i] = of[places[i]];
    return levels;
}

void CrownMarks::set(std::size_t bin, std::size_t block, bool swapped, const Block& marks) {
    Entry& entry = entries_[bin * blocks_->blocks().size() + block];
    if (marks.anyInLeaf) entry.inLeaf = copyMarks(block, swapped, marks.inLeaf);
    if (marks.anyBare) entry.bare = copyMarks(block, swapped, marks.bare);
}

CrownMarks::Part CrownMarks::of(std::size_t bin, std::size_t part) const {
    Part levels;
    for (std::size_t i = 0; i < 2 && 2 * part + i < blockOfHalf_.size(); ++i) {
        const std::uint32_t block = blockOfHalf_[2 * part + i];
        const Entry& entry = entries_[bin * blocks_->blocks().size() + block];
        const std::size_t first = (2 * part + i) * halfPart - blocks_->blocks()[block].first;
        if (entry.inLeaf) levels.inLeaf[i] = entry.inLeaf.get() + first;
        if (entry.bare) levels.bare[i] = entry.bare.get() + first;
    }
    return levels;
}

CrownRunCount::CrownRunCount(const CrownSweep& sweep, std::span<const TimedStep> steps,
                             std::span<const std::uint8_t> inLeaf)
    : sweep_(sweep) {
    for (std::size_t bin = 0; bin < sweep.bins(); ++bin) {
        firstOfBin_.push_back(std::uint32_t(binOfSpan_.size()));
        binOfSpan_.insert(binOfSpan_.end(), sweep.levels(bin).spans(), std::uint32_t(bin));
    }
    firstOfBin_.push_back(std::uint32_t(binOfSpan_.size()));
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const StepPlace& place = steps[i].place;
        const std::uint32_t span = firstOfBin_[place.bin] + sweep.levels(place.bin).spanOf(place.sun);
        (inLeaf[i] != 0 ? leafy_ : bare_).push_back({span, place.sun, steps[i].startsRun});
    }
}

namespace {

struct PartMarks {
    alignas(64) DarkLevels dark[lanesPerPart] = {};
    DarkLevels any = 0;
};

PartMarks joinHalves(const DarkLevels* const* halves) {
    PartMarks marks;
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < halfPart && halves[i] != nullptr; ++k)
            marks.any |= marks.dark[i * halfPart + k] = halves[i][k];
    return marks;
}

RunLanes maxOf(const RunLanes& a, const RunLanes& b) {
    RunLanes larger;
    for (std::size_t i = 0; i < lanesPerPart; ++i) larger.values[i] = std::max(a.values[i], b.values[i]);
    return larger;
}

// Rays have decided the runs of buildings alone; crowns count where they make a longer one.
RunLanes keepDecidedRuns(const RunLanes& withTrees, const RunLanes& plain, const RunLanes& decided) {
    RunLanes joined = decided;
    for (std::size_t i = 0; i < lanesPerPart; ++i)
        if (withTrees.values[i] > plain.values[i])
            joined.values[i] = std::max(withTrees.values[i], decided.values[i]);
    return joined;
}

// Of 64 lanes of which nothing is hidden above.
alignas(64) constexpr auto noneAbove = [] {
    std::array<HorizonCode, lanesPerPart> codes{};
    codes.fill(std::numeric_limits<HorizonCode>::max());
    return codes;
}();

// The longest run of one lane of which overhangs hide `gaps`, by bin.
std::int16_t walkLane(const std::vector<SpanLanes>& spans, std::span<const SpanStep> steps, std::size_t lane,
                      const GapsByBin& gaps, std::span<const std::uint32_t> binOfSpan) {
    int run = 0, longest = 0;
    for (const SpanStep& step : steps) {
        const SpanLanes& of = spans[step.span];
        const bool isHidden = of.below[lane] > step.sun || step.sun > of.above[lane] ||
                              isInGap(gaps[binOfSpan[step.span]], step.sun);
        run = !isHidden ? 0 : step.startsRun ? 1 : run + 1;
        longest = std::max(longest, run);
    }
    return std::int16_t(longest);
}

}  // namespace

// Those of a bin's horizon where no crown shades a span.
void CrownRunCount::addLanes(std::size_t bin, const RunLanes& horizon, const DarkLevels* const* halves,
                             Memory& memory, std::vector<SpanLanes>& to) const {
    const CrownLevels& levels = sweep_.levels(bin);
    PartMarks marks = joinHalves(halves);
    for (std::size_t span = 0; span < levels.spans(); ++span) {
        SpanLanes& lanes = to[firstOfBin_[bin] + span];
        lanes = {horizon.values, noneAbove.data()};
        const DarkLevels beside = 3U << span >> 1U;
        if ((marks.any & beside & levels.all()) == 0) continue;
        memory.made.emplace_back();
        makeDarkSpan(levels, span, horizon.values, marks.dark, memory.made.back());
        lanes = {memory.made.back().below, memory.made.back().above};
    }
}

// False: no crown shades any of the part.
bool CrownRunCount::findLanes(std::span<const RunLanes> horizons, const CrownMarks& marks, std::size_t part,
                              Memory& memory) const {
    memory.made.clear();
    memory.made.reserve(2 * binOfSpan_.size());  // so that none moves
    memory.inLeaf.resize(binOfSpan_.size());
    memory.bare.resize(binOfSpan_.size());
    for (std::size_t bin = 0; bin < horizons.size(); ++bin) {
        const CrownMarks::Part own = marks.of(bin, part);
        addLanes(bin, horizons[bin], own.inLeaf, memory, memory.inLeaf);
        addLanes(bin, horizons[bin], own.bare, memory, memory.bare);
    }
    return !memory.made.empty();
}

CrownRunCount::Runs CrownRunCount::walk(const Memory& memory) const {
    RunLanes leafy, evergreen, bare;
    walkSpans(memory.inLeaf, leafy_, leafy);
    walkSpans(memory.inLeaf, bare_, evergreen);
    walkSpans(memory.bare, bare_, bare);
    return {maxOf(leafy, evergreen), maxOf(leafy, bare)};
}

// Filling the space below the gaps can only lengthen runs, as in RunCount. `maximum`: runs with it filled.
void CrownRunCount::walkBelowOverhangs(const RunMemory& plain, const Runs& maximum, Memory& memory,
                                       Runs& runs) const {
    forEachLane(plain.overhangs, [&](std::size_t lane, std::span<const OverhangGap> own) {
        const bool isEvergreen = maximum.evergreen.values[lane] > runs.evergreen.values[lane],
                   isSeasonal = maximum.seasonal.values[lane] > runs.seasonal.values[lane];
        if (!isEvergreen && !isSeasonal) return;
        listByBin(own, plain.lanes.size(), memory.gaps);
        const auto longest = [&](const std::vector<SpanLanes>& spans, const std::vector<SpanStep>& steps) {
            return walkLane(spans, steps, lane, memory.gaps, binOfSpan_);
        };
        const std::int16_t leafy = longest(memory.inLeaf, leafy_);
        if (isEvergreen) runs.evergreen.values[lane] = std::max(leafy, longest(memory.inLeaf, bare_));
        if (isSeasonal) runs.seasonal.values[lane] = std::max(leafy, longest(memory.bare, bare_));
    });
}

CrownRunCount::Runs CrownRunCount::of(const RunMemory& plain, const CrownMarks& marks, std::size_t part,
                                      const RunLanes& decided, Memory& memory) const {
    const bool hasOverhangs = !plain.overhangs.empty();
    Runs maximum;
    if (hasOverhangs) {
        if (!findLanes(plain.filled, marks, part, memory)) return {decided, decided};
        maximum = walk(memory);
    }
    if (!findLanes(plain.lanes, marks, part, memory)) return {decided, decided};
    Runs runs = walk(memory);
    if (hasOverhangs) walkBelowOverhangs(plain, maximum, memory, runs);
    return {keepDecidedRuns(runs.evergreen, plain.undecided, decided),
            keepDecidedRuns(runs.seasonal, plain.undecided, decided)};
}

}  // namespace noonmark
