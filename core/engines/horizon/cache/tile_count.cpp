#include "core/engines/horizon/cache/cached_tile.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "core/engines/horizon/counting/short_sums.h"

namespace noonmark {

namespace {

constexpr std::size_t numbersATask = maxShortNumbers;
constexpr std::uint32_t numbersALine = 32;

bool hasReceivers(const ReceiverBlocks& blocks, std::size_t first, std::size_t end) {
    for (std::size_t number = first; number < std::min(end, blocks.numbers()); ++number)
        if (blocks.cell(number) != ReceiverBlocks::padding) return true;
    return false;
}

// Ranges of numbers with receivers; adjacent ranges are joined.
std::vector<NumberRange> linesOfReceivers(const ReceiverBlocks& blocks, std::size_t task) {
    std::vector<NumberRange> lines;
    const auto end = std::uint32_t(std::min((task + 1) * numbersATask, blocks.numbers()));
    for (auto first = std::uint32_t(task * numbersATask); first < end; first += numbersALine) {
        if (!hasReceivers(blocks, first, first + numbersALine)) continue;
        if (lines.empty() || lines.back().end != first) lines.push_back({first, first});
        lines.back().end = first + numbersALine;
    }
    return lines;
}

}  // namespace

void TileCount::computePeriod(const ReceiverBlocks& blocks, std::span<const CachedBin> bins,
                              const BinnedSun& binned, const std::stop_token& stop) {
    if (!stop.stop_requested()) addHidden(blocks, bins, changesFor(blocks, bins, binned), stop);
    if (stop.stop_requested()) *this = {};
    allOld(blocks);
}

void TileCount::allOld(const ReceiverBlocks& blocks) {
    grossIsOld_.assign(partsOf(blocks), 1);
    runsAreOld_ = grossIsOld_;
}

void TileCount::beginNew(const ReceiverBlocks& blocks, std::span<const std::uint32_t> numbers) {
    if (grossIsOld_.empty()) allOld(blocks);
    for (const std::uint32_t number : numbers) {
        grossIsOld_[number / lanesPerPart] = runsAreOld_[number / lanesPerPart] = 1;
        if (!hidden_.empty()) hidden_[number] = 0;
    }
}

// The changes to be added to the sums: for each bin, added minus removed suns; or, if that is less work, all
// suns after a reset. A bin that was swept again gives the same results for the suns it already covered.
std::vector<TileCount::BinChange> TileCount::changesFor(const ReceiverBlocks& blocks,
                                                        std::span<const CachedBin> bins,
                                                        const BinnedSun& binned) {
    if (hidden_.size() != blocks.numbers()) {
        hidden_.assign(blocks.numbers(), 0);
        suns_.clear();
    }
    suns_.resize(bins.size());
    std::vector<Suns> before(bins.size());
    std::swap(suns_, before);
    for (const AzimuthBin& bin : binned.bins) suns_[bin.number] = bin.suns;
    std::size_t others = 0;
    for (std::size_t number = 0; number < bins.size(); ++number) others += suns_[number] != before[number];
    if (others > binned.bins.size()) {
        hidden_.assign(blocks.numbers(), 0);
        before.assign(bins.size(), {});
    }
    std::vector<BinChange> changes(bins.size());
    tbb::parallel_for(std::size_t{0}, bins.size(), [&](std::size_t number) {
        changes[number] = {std::uint32_t(number), findSunChanges(suns_[number], before[number]), {}};
        if (!changes[number].changes.empty() && !bins[number].gaps.empty())
            changes[number].hidden.emplace_back(suns_[number], before[number]);
    });
    std::erase_if(changes, [](const BinChange& change) { return change.changes.empty(); });
    return changes;
}

void TileCount::addHidden(const ReceiverBlocks& blocks, std::span<const CachedBin> bins,
                          const std::vector<BinChange>& changes, const std::stop_token& stop) {
    const std::size_t tasks = (blocks.numbers() + numbersATask - 1) / numbersATask;
    tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
        const std::size_t first = task * numbersATask;
        const std::vector<NumberRange> lines = linesOfReceivers(blocks, task);
        TileShortSums sums(first, lines, hidden_.data());
        for (const BinChange& change : changes) {
            if (stop.stop_requested()) return;
            for (const CountChange& some : change.changes) sums.add(some, bins[change.number].codes.data());
            for (const HiddenSuns& hidden : change.hidden)
                addGaps(bins[change.number], hidden, first, first + numbersATask);
        }
        sums.flush();
    });
}

// For numbers [first, end).
void TileCount::addGaps(const CachedBin& bin, const HiddenSuns& hidden, std::size_t first, std::size_t end) {
    const auto from = std::ranges::lower_bound(bin.gaps, first, {}, &Gap::number),
               to = std::ranges::lower_bound(bin.gaps, end, {}, &Gap::number);
    forEachReceiver(std::span<const Gap>(from, to), [&](std::span<const Gap> own) {
        const std::uint32_t number = own.front().number;
        hidden_[number] += countHidden(bin.codes[number], own, hidden);
    });
}

void TileCount::take(TileSteps& steps) {
    auto& more = steps.more;
    auto& parts = steps.parts;
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t part) {
        if (std::exchange(parts[part], std::uint8_t(0)) == 0) return;
        grossIsOld_[part] = runsAreOld_[part] = 1;
        for (std::size_t i = part * lanesPerPart; i < std::min((part + 1) * lanesPerPart, more.size()); ++i)
            hidden_[i] += std::exchange(more[i], 0U);
    });
}

void TileCount::writeGross(const ReceiverBlocks& blocks, ShadowField& field, const std::stop_token& stop) {
    tbb::parallel_for(std::size_t{0}, partsOf(blocks), [&](std::size_t part) {
        if (stop.stop_requested() || grossIsOld_[part] == 0) return;
        noonmark::writeGross(blocks, part, hidden_, field);
        grossIsOld_[part] = 0;
    });
}

void TileCount::writeRuns(const ReceiverBlocks& blocks, std::span<const CachedBin> bins,
                          const BinnedSun& binned, const RunCount& count, ShadowField& field,
                          const std::stop_token& stop) {
    BinCodes codes;
    BinGaps gaps;
    for (const AzimuthBin& bin : binned.bins) {
        codes.push_back(bins[bin.number].codes);
        gaps.push_back(bins[bin.number].gaps);
    }
    tbb::enumerable_thread_specific<RunMemory> memory;
    tbb::parallel_for(std::size_t{0}, partsOf(blocks), [&](std::size_t part) {
        if (stop.stop_requested() || runsAreOld_[part] == 0) return;
        if (hasReceivers(blocks, part * lanesPerPart, (part + 1) * lanesPerPart))
            noonmark::writeRuns(blocks, part, count.longestRuns(codes, gaps, part, memory.local()), field);
        runsAreOld_[part] = 0;
    });
}

}  // namespace noonmark
