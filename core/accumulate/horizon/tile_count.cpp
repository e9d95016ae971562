#include "core/accumulate/horizon/tile_count.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace noonmark {

namespace {

bool hasReceivers(const ReceiverBlocks& blocks, std::size_t part) {
    const std::size_t end = std::min((part + 1) * lanesARun, blocks.numbers());
    for (std::size_t number = part * lanesARun; number < end; ++number)
        if (blocks.cell(number) != ReceiverBlocks::padding) return true;
    return false;
}

// Numbers that one task counts through all bins: their sums and a bin's table stay in cache.
constexpr std::size_t numbersATask = 65'536;
// Stretches of receivers as close as this are counted as one.
constexpr std::uint32_t smallGap = 4;

std::vector<Stretch> stretchesOfReceivers(const ReceiverBlocks& blocks) {
    std::vector<Stretch> stretches;
    for (std::uint32_t number = 0; number < blocks.numbers(); ++number) {
        if (blocks.cell(number) == ReceiverBlocks::padding) continue;
        const bool joins = !stretches.empty() && number <= stretches.back().end + smallGap &&
                           number / numbersATask == stretches.back().first / numbersATask;
        if (joins)
            stretches.back().end = number + 1;
        else
            stretches.push_back({number, number + 1});
    }
    return stretches;
}

}  // namespace

void TileCount::retime(const ReceiverBlocks& blocks, std::span<const KeptBin> bins, const BinnedSun& binned,
                       const std::stop_token& stop) {
    if (!stop.stop_requested()) addHidden(blocks, bins, tablesFor(blocks, bins.size(), binned), stop);
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
        grossIsOld_[number / lanesARun] = runsAreOld_[number / lanesARun] = 1;
        if (!hidden_.empty()) hidden_[number] = 0;
    }
}

// What is to be added to the sums: of each bin the suns that came, less those that went; or, where that is
// less work, all anew. A bin that was swept anew says the same as before of the suns that it knew.
std::vector<TileCount::BinTable> TileCount::tablesFor(const ReceiverBlocks& blocks, std::size_t bins,
                                                      const BinnedSun& binned) {
    std::vector<std::vector<HorizonCode>> suns(bins);
    for (const AzimuthBin& bin : binned.bins) suns[bin.number] = bin.suns;
    std::swap(suns, suns_);
    suns.resize(bins);
    std::vector<BinTable> changes;
    for (std::uint32_t number = 0; number < bins; ++number)
        if (suns[number] != suns_[number])
            changes.push_back({number, HiddenSuns(suns_[number], suns[number])});
    if (changes.size() < binned.bins.size() && hidden_.size() == blocks.numbers()) return changes;
    hidden_.assign(blocks.numbers(), 0);
    changes.clear();
    for (const AzimuthBin& bin : binned.bins) changes.push_back({bin.number, HiddenSuns(bin.suns)});
    return changes;
}

void TileCount::addHidden(const ReceiverBlocks& blocks, std::span<const KeptBin> bins,
                          const std::vector<BinTable>& tables, const std::stop_token& stop) {
    const std::vector<Stretch> stretches = stretchesOfReceivers(blocks);
    const auto firstOf = [&](std::size_t task) {
        return std::ranges::lower_bound(stretches, task * numbersATask, {}, &Stretch::first);
    };
    tbb::parallel_for(
        std::size_t{0}, (blocks.numbers() + numbersATask - 1) / numbersATask, [&](std::size_t task) {
            const std::span own(firstOf(task), firstOf(task + 1));
            for (const BinTable& table : tables) {
                if (stop.stop_requested()) return;
                table.hidden.addTo(bins[table.number].codes.data(), own, hidden_.data());
                addGaps(bins[table.number], table.hidden, task * numbersATask, (task + 1) * numbersATask);
            }
        });
}

// Of numbers [first, end).
void TileCount::addGaps(const KeptBin& bin, const HiddenSuns& hidden, std::size_t first, std::size_t end) {
    const auto from = std::ranges::lower_bound(bin.gaps, first, {}, &Gap::number),
               to = std::ranges::lower_bound(bin.gaps, end, {}, &Gap::number);
    forEachReceiver(std::span<const Gap>(from, to), [&](std::span<const Gap> own) {
        const std::uint32_t number = own.front().number;
        hidden_[number] += hiddenIn(bin.codes[number], own, hidden);
    });
}

// Adds to the sums of some parts.
void TileCount::take(const TileSteps& steps) {
    const auto& [more, parts] = steps;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        if (parts[part] == 0) continue;
        grossIsOld_[part] = runsAreOld_[part] = 1;
        for (std::size_t i = part * lanesARun; i < std::min((part + 1) * lanesARun, more.size()); ++i)
            hidden_[i] += more[i];
    }
}

void TileCount::writeGross(const ReceiverBlocks& blocks, ShadowField& field, const std::stop_token& stop) {
    tbb::parallel_for(std::size_t{0}, partsOf(blocks), [&](std::size_t part) {
        if (stop.stop_requested() || grossIsOld_[part] == 0) return;
        noonmark::writeGross(blocks, part, hidden_, field);
        grossIsOld_[part] = 0;
    });
}

void TileCount::writeRuns(const ReceiverBlocks& blocks, std::span<const KeptBin> bins,
                          const BinnedSun& binned, const PeriodCount& count, ShadowField& field,
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
        if (hasReceivers(blocks, part))
            noonmark::writeRuns(blocks, part, count.longestRuns(codes, gaps, part, memory.local()), field);
        runsAreOld_[part] = 0;
    });
}

}  // namespace noonmark
