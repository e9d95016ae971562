#include "core/accumulate/horizon/kept_tile.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace noonmark {

namespace {

std::vector<ReceiverBlocks::Masks> added(const ReceiverBlocks& now, const ReceiverBlocks& before,
                                         bool columns) {
    std::vector<ReceiverBlocks::Masks> masks(now.blocks().size());
    for (std::size_t i = 0; i < masks.size(); ++i)
        for (std::size_t line = 0; line < ReceiverBlocks::side; ++line)
            masks[i][line] = std::uint16_t(now.masks(i, columns)[line] & ~before.masks(i, columns)[line]);
    return masks;
}

void findNew(TileEdit& edit) {
    for (std::size_t i = 0; i < edit.newRows.size(); ++i) {
        if (edit.newRows[i] == ReceiverBlocks::Masks{}) continue;
        edit.newBlocks.push_back(i);
        const ReceiverBlocks::Block& block = edit.blocks.blocks()[i];
        const std::uint8_t* places = edit.blocks.places(block, false);
        for (std::uint32_t n = 0; n < block.count; ++n)
            if ((edit.newRows[i][places[n] / ReceiverBlocks::side] >> (places[n] % ReceiverBlocks::side) &
                 1U) != 0)
                edit.newNumbers.push_back(block.first + n);
    }
}

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

}  // namespace

KeptTile::KeptTile(const Receivers& receivers, const TileBox& box, std::size_t bins)
    : box_(box), blocks_(receivers, box, Numbering::cells), bins_(bins) {}

std::size_t KeptTile::bytes() const {
    std::size_t codes = 0;
    for (const KeptBin& bin : bins_) codes += bin.codes.capacity();
    return codes * sizeof(HorizonCode);
}

void KeptTile::drop() {
    for (KeptBin& bin : bins_) bin = {};
    count_ = {};
}

std::size_t KeptTile::retime(const KeptWalls& walls, double cellM, const BinnedSun& binned,
                             const std::stop_token& stop) {
    const std::size_t swept = sweep(walls, cellM, binned, stop);
    if (!stop.stop_requested()) addHidden(tablesFor(binned), stop);
    if (stop.stop_requested()) count_ = {};
    allOld();
    return swept;
}

void KeptTile::allOld() {
    count_.grossIsOld.assign(partsOf(blocks_), 1);
    count_.runsAreOld = count_.grossIsOld;
}

std::size_t KeptTile::sweep(const KeptWalls& walls, double cellM, const BinnedSun& binned,
                            const std::stop_token& stop) {
    std::atomic<std::size_t> swept{0};
    tbb::enumerable_thread_specific<SquareSweep> sweeps;
    tbb::parallel_for(std::size_t{0}, binned.bins.size(), [&](std::size_t i) {
        const AzimuthBin& bin = binned.bins[i];
        KeptBin& kept = bins_[bin.number];
        if (stop.stop_requested() || kept.holds(bin)) return;
        kept.lowest = kept.codes.empty() ? bin.lowest() : std::min(kept.lowest, bin.lowest());
        kept.codes.resize(blocks_.numbers());
        sweepBin(sweeps.local(), walls.list(), blocks_, {}, bin.away, kept.lowest, cellM, kept.codes, stop);
        if (stop.stop_requested()) kept = {};
        ++swept;
    });
    return swept;
}

// What is to be added to the sums: of each bin the suns that came, less those that went; or, where that is
// less work, all anew. A bin that was swept anew says the same as before of the suns that it knew.
std::vector<KeptTile::BinTable> KeptTile::tablesFor(const BinnedSun& binned) {
    std::vector<std::vector<HorizonCode>> suns(bins_.size());
    for (const AzimuthBin& bin : binned.bins) suns[bin.number] = bin.suns;
    std::swap(suns, count_.suns);
    suns.resize(bins_.size());
    std::vector<BinTable> changes;
    for (std::uint32_t number = 0; number < bins_.size(); ++number)
        if (suns[number] != count_.suns[number])
            changes.push_back({number, HiddenSuns(count_.suns[number], suns[number])});
    if (changes.size() < binned.bins.size() && count_.hidden.size() == blocks_.numbers()) return changes;
    count_.hidden.assign(blocks_.numbers(), 0);
    changes.clear();
    for (const AzimuthBin& bin : binned.bins) changes.push_back({bin.number, HiddenSuns(bin.suns)});
    return changes;
}

std::vector<Stretch> KeptTile::stretchesOfReceivers() const {
    std::vector<Stretch> stretches;
    for (std::uint32_t number = 0; number < blocks_.numbers(); ++number) {
        if (blocks_.cell(number) == ReceiverBlocks::padding) continue;
        const bool joins = !stretches.empty() && number <= stretches.back().end + smallGap &&
                           number / numbersATask == stretches.back().first / numbersATask;
        if (joins)
            stretches.back().end = number + 1;
        else
            stretches.push_back({number, number + 1});
    }
    return stretches;
}

void KeptTile::addHidden(const std::vector<BinTable>& tables, const std::stop_token& stop) {
    const std::vector<Stretch> stretches = stretchesOfReceivers();
    const auto firstOf = [&](std::size_t task) {
        return std::ranges::lower_bound(stretches, task * numbersATask, {}, &Stretch::first);
    };
    tbb::parallel_for(std::size_t{0}, (blocks_.numbers() + numbersATask - 1) / numbersATask,
                      [&](std::size_t task) {
                          const std::span own(firstOf(task), firstOf(task + 1));
                          for (const BinTable& table : tables) {
                              if (stop.stop_requested()) return;
                              table.hidden.addTo(bins_[table.number].codes.data(), own, count_.hidden.data());
                          }
                      });
}

void KeptTile::note(std::span<const CodeChange> changes, const HiddenSuns& hidden,
                    std::span<std::uint32_t> more, std::span<std::uint8_t> parts) const {
    for (const CodeChange& change : changes) {
        const std::uint32_t added = hidden(change.after) - hidden(change.before);
        if (added == 0) continue;
        more[change.number] += added;
        parts[change.number / lanesARun] = 1;
    }
}

void KeptTile::change(const Receivers& receivers, const KeptWalls& walls, const WallChange& change,
                      const BinnedSun& binned, const PeriodCount& count, double binDeg,
                      const std::stop_token& stop) {
    ReceiverBlocks now(receivers, box_, Numbering::cells);
    TileEdit edit{walls,
                  change,
                  now,
                  added(now, blocks_, false),
                  added(now, blocks_, true),
                  {},
                  {},
                  receivers.grid.cellM};
    findNew(edit);
    if (count_.grossIsOld.empty()) allOld();
    for (const std::uint32_t number : edit.newNumbers) {
        count_.grossIsOld[number / lanesARun] = count_.runsAreOld[number / lanesARun] = 1;
        if (!count_.hidden.empty()) count_.hidden[number] = 0;
    }
    std::vector<const HiddenSuns*> hidden(bins_.size(), nullptr);
    for (std::size_t i = 0; i < binned.bins.size(); ++i) hidden[binned.bins[i].number] = &count.hidden(i);
    struct Work {
        BinEdit edit;
        std::vector<std::uint32_t> more;
        std::vector<std::uint8_t> parts;
    };
    tbb::enumerable_thread_specific<Work> works{[&] {
        return Work{{}, std::vector<std::uint32_t>(now.numbers()), std::vector<std::uint8_t>(partsOf(now))};
    }};
    tbb::parallel_for(std::size_t{0}, bins_.size(), [&](std::size_t number) {
        KeptBin& bin = bins_[number];
        if (bin.codes.empty() || stop.stop_requested()) return;
        Work& work = works.local();
        const auto changes =
            work.edit.run(edit, middleAway(std::uint32_t(number), binDeg), bin.lowest, bin.codes);
        // Of a bin that the period does not visit the sums know nothing.
        if (hidden[number] != nullptr) note(changes, *hidden[number], work.more, work.parts);
    });
    for (const Work& work : works) take(work.more, work.parts);
    blocks_ = std::move(now);
    if (stop.stop_requested()) drop();
}

// Adds to the sums of some parts.
void KeptTile::take(std::span<const std::uint32_t> more, std::span<const std::uint8_t> parts) {
    for (std::size_t part = 0; part < parts.size(); ++part) {
        if (parts[part] == 0) continue;
        count_.grossIsOld[part] = count_.runsAreOld[part] = 1;
        for (std::size_t i = part * lanesARun; i < std::min((part + 1) * lanesARun, more.size()); ++i)
            count_.hidden[i] += more[i];
    }
}

void KeptTile::writeGross(ShadowField& field, const std::stop_token& stop) {
    tbb::parallel_for(std::size_t{0}, partsOf(blocks_), [&](std::size_t part) {
        if (stop.stop_requested() || count_.grossIsOld[part] == 0) return;
        noonmark::writeGross(blocks_, part, count_.hidden, field);
        count_.grossIsOld[part] = 0;
    });
}

void KeptTile::writeRuns(const BinnedSun& binned, const PeriodCount& count, ShadowField& field,
                         const std::stop_token& stop) {
    BinCodes codes;
    for (const AzimuthBin& bin : binned.bins) codes.push_back(bins_[bin.number].codes);
    tbb::enumerable_thread_specific<RunMemory> memory;
    tbb::parallel_for(std::size_t{0}, partsOf(blocks_), [&](std::size_t part) {
        if (stop.stop_requested() || count_.runsAreOld[part] == 0) return;
        if (hasReceivers(blocks_, part))
            noonmark::writeRuns(blocks_, part, count.longestRuns(codes, {}, part, memory.local()), field);
        count_.runsAreOld[part] = 0;
    });
}

}  // namespace noonmark
