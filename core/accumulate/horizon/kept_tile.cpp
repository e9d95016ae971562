#include "core/accumulate/horizon/kept_tile.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <utility>

namespace noonmark {

namespace {

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
    : box_(box), blocks_(receivers, box, Numbering::cells), known_(blocks_), bins_(bins) {}

std::size_t KeptTile::bytes() const {
    std::size_t bytes = 0;
    for (const KeptBin& bin : bins_) bytes += bin.bytes();
    return bytes;
}

void KeptTile::drop() {
    for (KeptBin& bin : bins_) bin = {};
    count_ = {};
    paged_ = false;
    memory_.reset();
}

void KeptTile::dropPages() {
    for (KeptBin& bin : bins_) bin.base.clear();
    paged_ = false;
}

std::size_t KeptTile::retime(const Receivers& receivers, const KeptWalls& walls, const BinnedSun& binned,
                             Progress& progress, const std::stop_token& stop) {
    const std::size_t swept = sweep(receivers, walls, binned, progress, stop);
    count_.retime(blocks_, bins_, binned, stop);
    return swept;
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
        TileSweep tiles;
        OpenSweep open;
        std::vector<HorizonCode> horizons;
        OpenList list;
    };
    tbb::enumerable_thread_specific<Memory> memory{};
};

std::size_t KeptTile::sweep(const Receivers& receivers, const KeptWalls& walls, const BinnedSun& binned,
                            Progress& progress, const std::stop_token& stop) {
    std::vector<AzimuthBin> missing;
    for (const AzimuthBin& bin : binned.bins)
        if (!bins_[bin.number].holds(bin)) missing.push_back({bin.number, bin.away, {KeptBin::below(bin)}});
    if (missing.empty()) return 0;
    dropPages();
    known_ = KnownCells(blocks_);
    lookAtGround(receivers, walls, false);
    Sweeping sweeping{walls, receivers.grid.cellM, stop};
    std::atomic<std::size_t> done{0};
    const std::vector<FanRange> fans = fansOf(sweptBins(missing));
    tbb::parallel_for(std::size_t{0}, fans.size(), [&](std::size_t i) {
        if (stop.stop_requested()) return;
        sweep(std::span(missing).subspan(fans[i].first, fans[i].size()), sweeping);
        progress.report(double(++done) / double(fans.size()), "sweeping horizons");
    });
    return missing.size();
}

// `missing`: bins of a fan.
void KeptTile::sweep(std::span<const AzimuthBin> missing, Sweeping& sweeping) {
    std::vector<SweptBin> swept = sweptBins(missing);
    for (std::size_t i = 0; i < swept.size(); ++i) {
        KeptBin& kept = bins_[missing[i].number];
        kept.lowest = kept.codes.empty() ? swept[i].lowest : std::min(kept.lowest, swept[i].lowest);
        kept.codes.resize(blocks_.numbers());
        swept[i].lowest = kept.lowest;
    }
    const auto take = [&](std::size_t bin, std::size_t block, const HorizonCode* square, bool swapped) {
        writeSquare(square, blocks_, blocks_.blocks()[block], swapped,
                    bins_[missing[bin].number].codes.data());
    };
    sweeping.memory.local().tiles.run({sweeping.walls.list(), blocks_, grounds_, sweeping.cellM}, swept, take,
                                      sweeping.stop);
    for (const AzimuthBin& bin : missing) findGaps(bins_[bin.number], bin.away, sweeping);
}

void KeptTile::findGaps(KeptBin& kept, glm::dvec2 away, Sweeping& sweeping) const {
    const KeptWalls& walls = sweeping.walls;
    Sweeping::Memory& memory = sweeping.memory.local();
    if (!walls.open().empty() && !sweeping.stop.stop_requested()) {
        const ShadowAxes axes(away);
        walls.open().across(axes, extentOf(box_, axes), tanOf(kept.lowest),
                            axes.alongPerDistance / sweeping.cellM, memory.list);
        const auto gaps =
            memory.open.intervals({memory.list, open_, away, kept.lowest, sweeping.cellM},
                                  ofReceivers(blocks_, kept.codes, memory.horizons), sweeping.stop);
        kept.gaps.assign(gaps.begin(), gaps.end());
    }
    if (sweeping.stop.stop_requested()) kept = {};
}

/// Of each thread.
struct KeptTile::EditMemory {
    struct Own {
        BinEdit codes;
        GapEdit gaps;
        TileSteps steps;
    };
    explicit EditMemory(std::size_t numbers) : own([numbers] { return Own{{}, {}, TileSteps(numbers)}; }) {}
    tbb::enumerable_thread_specific<Own> own;
};

struct KeptTile::Editing {
    TileEdit edit;
    const SunsByNumber& suns;
    const HiddenByNumber& hidden;  ///< empty where nothing hangs
    double binDeg;
    EditMemory& memory;
};

KeptTile::KeptTile(KeptTile&&) noexcept = default;
KeptTile& KeptTile::operator=(KeptTile&&) noexcept = default;
KeptTile::~KeptTile() = default;

// Where pages say nothing of these buildings what lies below them is not known.
ChangedCells KeptTile::become(const Receivers& receivers, std::span<const std::uint32_t> cells, bool again) {
    if (!again) known_ = KnownCells(blocks_);
    return noonmark::become(blocks_, known_, receivers, cells);
}

void KeptTile::change(const Receivers& receivers, std::span<const std::uint32_t> cells,
                      const KeptWalls& walls, const WallChange& change, CountedPeriod& period, double binDeg,
                      const std::stop_token& stop) {
    const bool again = change.again && paged_ && receivers.flat();
    const bool hangs = !walls.open().empty() || !change.removed.open.empty();
    const ChangedCells changed = become(receivers, cells, again);
    if (bytes() == 0) return;
    if (!again) dropPages();
    if (!receivers.flat() || hangs) lookAtGround(receivers, walls, !change.removed.open.empty());
    count_.beginNew(blocks_, changed.newNumbers);
    if (!memory_) memory_ = std::make_unique<EditMemory>(blocks_.numbers());
    const HiddenByNumber none;
    Editing editing{{walls, change, blocks_, known_, grounds_, open_, changed, again, receivers.flat(), hangs,
                     receivers.grid.columns, receivers.grid.cellM, stop},
                    period.suns(bins_.size()),
                    hangs ? period.hidden(bins_.size()) : none,
                    binDeg,
                    *memory_};
    tbb::parallel_for(std::size_t{0}, bins_.size(), [&](std::size_t number) {
        if (!bins_[number].codes.empty() && !stop.stop_requested())
            this->change(std::uint32_t(number), editing);
    });
    for (EditMemory::Own& own : memory_->own) count_.take(own.steps);
    paged_ = receivers.flat();
    if (stop.stop_requested()) drop();
}

// Of a bin that the period does not visit the sums know nothing.
void KeptTile::change(std::uint32_t number, Editing& editing) {
    KeptBin& bin = bins_[number];
    EditMemory::Own& memory = editing.memory.own.local();
    const glm::dvec2 away = middleAway(number, editing.binDeg);
    const auto changes = memory.codes.run(editing.edit, away, bin, editing.suns[number], memory.steps);
    if (!editing.edit.hangs) return;
    const GapEdit::Bin now{away, bin.lowest, bin.codes, changes, editing.hidden[number]};
    for (const GapChange& change : memory.gaps.run(editing.edit, now, bin.gaps))
        memory.steps.add(change.number, change.added);
}

void KeptTile::writeGross(ShadowField& field, const std::stop_token& stop) {
    count_.writeGross(blocks_, field, stop);
}

void KeptTile::writeRuns(const BinnedSun& binned, const RunCount& count, ShadowField& field,
                         const std::stop_token& stop) {
    count_.writeRuns(blocks_, bins_, binned, count, field, stop);
}

}  // namespace noonmark
