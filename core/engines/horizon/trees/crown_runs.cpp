#include "core/engines/horizon/trees/crown_runs.h"

#include <algorithm>
#include <bit>
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

std::unique_ptr<CrownMarks::Levels[]> CrownMarks::copyMarks(std::size_t block, bool swapped,
                                                            const Levels* of) const {
    const ReceiverBlocks::Block& own = blocks_->blocks()[block];
    const std::uint8_t* places = blocks_->places(own, swapped);
    auto levels = std::make_unique<Levels[]>(paddedCount(own));
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
                             std::span<const std::uint8_t> inLeaf) {
    for (std::size_t bin = 0, levels = 0; bin <= sweep.bins(); ++bin) {
        firstOfBin_.push_back(std::uint32_t(levels));
        if (bin < sweep.bins()) levels += sweep.levels(bin).count;
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const StepPlace& place = steps[i].place;
        const std::uint32_t level = firstOfBin_[place.bin] + sweep.levels(place.bin).levelOf(place.sun);
        (inLeaf[i] != 0 ? leafy_ : bare_).push_back({level, place.sun, steps[i].startsRun});
    }
}

namespace {

unsigned uniteHalves(const CrownMarks::Levels* const* halves) {
    unsigned any = 0;
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < halfPart && halves[i] != nullptr; ++k) any |= halves[i][k];
    return any;
}

// Where crowns shade, every sun of the level is hidden.
void hideLevel(const RunLanes& horizon, const CrownMarks::Levels* const* halves, unsigned level,
               RunLanes& lanes) {
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < halfPart; ++k) {
            const bool isShaded = halves[i] != nullptr && (halves[i][k] >> level & 1U) != 0;
            lanes.values[i * halfPart + k] =
                isShaded ? std::numeric_limits<std::int16_t>::max() : horizon.values[i * halfPart + k];
        }
}

// The lanes of a bin's levels, those of its horizon where no crown shades.
void setLanes(const RunLanes& horizon, const CrownMarks::Levels* const* halves, std::size_t levels,
              std::vector<RunLanes>& made, const std::int16_t** lanes) {
    std::fill_n(lanes, levels, horizon.values);
    for (unsigned bits = uniteHalves(halves); bits != 0; bits &= bits - 1) {
        const auto level = unsigned(std::countr_zero(bits));
        made.emplace_back();
        hideLevel(horizon, halves, level, made.back());
        lanes[level] = made.back().values;
    }
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

}  // namespace

// False: no crown shades any of the part.
bool CrownRunCount::findLanes(std::span<const RunLanes> horizons, const CrownMarks& marks, std::size_t part,
                              Memory& memory) const {
    const std::size_t all = firstOfBin_.back();
    memory.made.clear();
    memory.made.reserve(2 * all);  // so that none moves
    memory.inLeaf.resize(all);
    memory.bare.resize(all);
    for (std::size_t bin = 0; bin < horizons.size(); ++bin) {
        const CrownMarks::Part own = marks.of(bin, part);
        const std::size_t first = firstOfBin_[bin], levels = firstOfBin_[bin + 1] - first;
        setLanes(horizons[bin], own.inLeaf, levels, memory.made, memory.inLeaf.data() + first);
        setLanes(horizons[bin], own.bare, levels, memory.made, memory.bare.data() + first);
    }
    return !memory.made.empty();
}

CrownRunCount::Runs CrownRunCount::of(std::span<const RunLanes> horizons, const CrownMarks& marks,
                                      std::size_t part, const RunLanes& plain, const RunLanes& decided,
                                      Memory& memory) const {
    if (!findLanes(horizons, marks, part, memory)) return {decided, decided};
    RunLanes leafy, evergreen, bare;
    walkLevels(memory.inLeaf, leafy_, leafy);
    walkLevels(memory.inLeaf, bare_, evergreen);
    walkLevels(memory.bare, bare_, bare);
    return {keepDecidedRuns(maxOf(leafy, evergreen), plain, decided),
            keepDecidedRuns(maxOf(leafy, bare), plain, decided)};
}

}  // namespace noonmark
