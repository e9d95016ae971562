#include "core/accumulate/horizon/kept_tile.h"

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

// What hangs is looked at from receivers only.
std::span<const HorizonCode> ofReceivers(const ReceiverBlocks& blocks, std::span<const HorizonCode> codes,
                                         std::vector<HorizonCode>& memory) {
    memory.assign(codes.begin(), codes.end());
    for (std::size_t number = 0; number < memory.size(); ++number)
        if (blocks.cell(number) == ReceiverBlocks::padding) memory[number] = OpenSweep::blind;
    return memory;
}

}  // namespace

KeptTile::KeptTile(const Receivers& receivers, const TileBox& box, std::size_t bins)
    : box_(box), blocks_(receivers, box, Numbering::cells), bins_(bins) {}

std::size_t KeptTile::bytes() const {
    std::size_t bytes = 0;
    for (const KeptBin& bin : bins_)
        bytes += bin.codes.capacity() * sizeof(HorizonCode) + bin.gaps.capacity() * sizeof(Gap);
    return bytes;
}

void KeptTile::drop() {
    for (KeptBin& bin : bins_) bin = {};
    count_ = {};
}

std::size_t KeptTile::retime(const Receivers& receivers, const KeptWalls& walls, const BinnedSun& binned,
                             const std::stop_token& stop) {
    const std::size_t swept = sweep(receivers, walls, binned, stop);
    if (!stop.stop_requested()) addHidden(tablesFor(binned), stop);
    if (stop.stop_requested()) count_ = {};
    allOld();
    return swept;
}

void KeptTile::allOld() {
    count_.grossIsOld.assign(partsOf(blocks_), 1);
    count_.runsAreOld = count_.grossIsOld;
}

// `hung`: whether something that went did.
void KeptTile::lookAtGround(const Receivers& receivers, const KeptWalls& walls, bool hung) {
    const double datumM = walls.list().datumM;
    grounds_ = BlockGrounds(receivers, blocks_, datumM);
    if (walls.open().empty() && !hung) return;
    if (open_.numbers.empty() || !receivers.flat()) open_ = OpenTile(receivers, blocks_, datumM);
}

struct KeptTile::Sweeping {
    const KeptWalls& walls;
    double cellM;
    const std::stop_token& stop;
    struct Memory {
        SquareSweep squares;
        OpenSweep open;
        std::vector<HorizonCode> horizons;
    };
    tbb::enumerable_thread_specific<Memory> memory{};
};

std::size_t KeptTile::sweep(const Receivers& receivers, const KeptWalls& walls, const BinnedSun& binned,
                            const std::stop_token& stop) {
    std::vector<const AzimuthBin*> missing;
    for (const AzimuthBin& bin : binned.bins)
        if (!bins_[bin.number].holds(bin)) missing.push_back(&bin);
    if (missing.empty()) return 0;
    lookAtGround(receivers, walls, false);
    Sweeping sweeping{walls, receivers.grid.cellM, stop};
    tbb::parallel_for(std::size_t{0}, missing.size(), [&](std::size_t i) {
        if (!stop.stop_requested()) sweep(bins_[missing[i]->number], *missing[i], sweeping);
    });
    return missing.size();
}

void KeptTile::sweep(KeptBin& kept, const AzimuthBin& bin, Sweeping& sweeping) const {
    const KeptWalls& walls = sweeping.walls;
    Sweeping::Memory& memory = sweeping.memory.local();
    const HorizonCode lowest = KeptBin::below(bin);
    kept.lowest = kept.codes.empty() ? lowest : std::min(kept.lowest, lowest);
    kept.codes.resize(blocks_.numbers());
    sweepBin(memory.squares, walls.list(), blocks_, grounds_, bin.away, kept.lowest, sweeping.cellM,
             kept.codes, sweeping.stop);
    if (!walls.open().empty() && !sweeping.stop.stop_requested()) {
        const auto gaps =
            memory.open.intervals({walls.open().all(), open_, bin.away, kept.lowest, sweeping.cellM},
                                  ofReceivers(blocks_, kept.codes, memory.horizons), sweeping.stop);
        kept.gaps.assign(gaps.begin(), gaps.end());
    }
    if (sweeping.stop.stop_requested()) kept = {};
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
                              addGaps(table, task * numbersATask, (task + 1) * numbersATask);
                          }
                      });
}

// Of numbers [first, end).
void KeptTile::addGaps(const BinTable& table, std::size_t first, std::size_t end) {
    const KeptBin& bin = bins_[table.number];
    const auto from = std::ranges::lower_bound(bin.gaps, first, {}, &Gap::number),
               to = std::ranges::lower_bound(bin.gaps, end, {}, &Gap::number);
    forEachReceiver(std::span<const Gap>(from, to), [&](std::span<const Gap> own) {
        const std::uint32_t number = own.front().number;
        count_.hidden[number] += hiddenIn(bin.codes[number], own, table.hidden);
    });
}

struct KeptTile::Editing {
    TileEdit edit;
    /// Of one thread: what is to be added to the sums.
    struct Memory {
        BinEdit codes;
        GapEdit gaps;
        std::vector<std::uint32_t> more;
        std::vector<std::uint8_t> parts;

        void add(std::uint32_t number, std::uint32_t steps) {
            more[number] += steps;
            parts[number / lanesARun] = 1;
        }
    };
    tbb::enumerable_thread_specific<Memory> memory{};

    [[nodiscard]] bool hangs() const {
        return !edit.walls.open().empty() || !edit.change.removed.open.empty();
    }
};

void KeptTile::change(const Receivers& receivers, std::span<const float> groundBeforeM,
                      const KeptWalls& walls, const WallChange& change, const BinnedSun& binned,
                      const PeriodCount& count, double binDeg, const std::stop_token& stop) {
    const ReceiverBlocks before = std::exchange(blocks_, ReceiverBlocks(receivers, box_, Numbering::cells));
    if (bytes() == 0) return;
    const ChangedCells cells = changedCells(blocks_, before, receivers, groundBeforeM);
    lookAtGround(receivers, walls, !change.removed.open.empty());
    beginNew(cells);
    std::vector<const HiddenSuns*> hidden(bins_.size(), nullptr);
    for (std::size_t i = 0; i < binned.bins.size(); ++i) hidden[binned.bins[i].number] = &count.hidden(i);
    Editing editing{
        {walls, change, blocks_, grounds_, open_, cells, receivers.grid.columns, receivers.grid.cellM, stop}};
    tbb::parallel_for(std::size_t{0}, bins_.size(), [&](std::size_t number) {
        if (bins_[number].codes.empty() || stop.stop_requested()) return;
        this->change(std::uint32_t(number), middleAway(std::uint32_t(number), binDeg), hidden[number],
                     editing);
    });
    for (const Editing::Memory& memory : editing.memory) take(memory.more, memory.parts);
    if (stop.stop_requested()) drop();
}

void KeptTile::beginNew(const ChangedCells& cells) {
    if (count_.grossIsOld.empty()) allOld();
    for (const std::uint32_t number : cells.newNumbers) {
        count_.grossIsOld[number / lanesARun] = count_.runsAreOld[number / lanesARun] = 1;
        if (!count_.hidden.empty()) count_.hidden[number] = 0;
    }
}

// Of a bin that the period does not visit the sums know nothing.
void KeptTile::change(std::uint32_t number, glm::dvec2 away, const HiddenSuns* hidden, Editing& editing) {
    KeptBin& bin = bins_[number];
    Editing::Memory& memory = editing.memory.local();
    memory.more.resize(blocks_.numbers());
    memory.parts.resize(partsOf(blocks_));
    const auto changes = memory.codes.run(editing.edit, away, bin.lowest, bin.codes);
    for (const CodeChange& change : changes)
        if (const std::uint32_t steps =
                hidden == nullptr ? 0 : (*hidden)(change.after) - (*hidden)(change.before);
            steps != 0)
            memory.add(change.number, steps);
    if (!editing.hangs()) return;
    const GapEdit::Bin now{away, bin.lowest, bin.codes, changes, hidden};
    for (const GapChange& change : memory.gaps.run(editing.edit, now, bin.gaps))
        memory.add(change.number, change.added);
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
    BinGaps gaps;
    for (const AzimuthBin& bin : binned.bins) {
        codes.push_back(bins_[bin.number].codes);
        gaps.push_back(bins_[bin.number].gaps);
    }
    tbb::enumerable_thread_specific<RunMemory> memory;
    tbb::parallel_for(std::size_t{0}, partsOf(blocks_), [&](std::size_t part) {
        if (stop.stop_requested() || count_.runsAreOld[part] == 0) return;
        if (hasReceivers(blocks_, part))
            noonmark::writeRuns(blocks_, part, count.longestRuns(codes, gaps, part, memory.local()), field);
        count_.runsAreOld[part] = 0;
    });
}

}  // namespace noonmark
