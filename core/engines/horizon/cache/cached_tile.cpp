#include "core/engines/horizon/cache/cached_tile.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <atomic>
#include <utility>

#include "core/describe/text.h"

namespace noonmark {

CountedPeriod::CountedPeriod(const SunSteps& sun, double binDeg)
    : binned_(binSun(sun, binDeg, BinDirection::middle)), steps_(makeTimedSteps(sun, binned_)) {}

const RunCount& CountedPeriod::runs() {
    if (!runs_) runs_.emplace(std::exchange(steps_, {}));
    return *runs_;
}

const HiddenByNumber& CountedPeriod::hidden(std::size_t bins) {
    if (!hidden_.empty()) return hidden_;
    tables_.resize(binned_.bins.size());
    tbb::parallel_for(std::size_t{0}, tables_.size(),
                      [&](std::size_t i) { tables_[i].emplace(binned_.bins[i].suns); });
    hidden_.resize(bins, nullptr);
    for (std::size_t i = 0; i < tables_.size(); ++i) hidden_[binned_.bins[i].number] = &*tables_[i];
    return hidden_;
}

const SunsByNumber& CountedPeriod::suns(std::size_t bins) {
    if (!suns_.empty()) return suns_;
    suns_.resize(bins);
    tbb::parallel_for(std::size_t{0}, binned_.bins.size(), [&](std::size_t i) {
        suns_[binned_.bins[i].number] = findSunChanges(binned_.bins[i].suns, {});
    });
    return suns_;
}

namespace {

// Overhangs are examined from receivers only.
std::span<const HorizonCode> ofReceivers(const ReceiverBlocks& blocks, std::span<const HorizonCode> codes,
                                         std::vector<HorizonCode>& memory) {
    memory.assign(codes.begin(), codes.end());
    for (std::size_t number = 0; number < memory.size(); ++number)
        if (blocks.cell(number) == ReceiverBlocks::padding) memory[number] = OverhangSweep::blind;
    return memory;
}

}  // namespace

CachedTile::CachedTile(const Receivers& receivers, const TileBox& box, std::size_t bins)
    : box_(box), blocks_(receivers, box, Numbering::cells), known_(blocks_), bins_(bins) {}

std::size_t CachedTile::bytes() const {
    std::size_t bytes = 0;
    for (const CachedBin& bin : bins_) bytes += bin.bytes();
    return bytes;
}

void CachedTile::drop() {
    for (CachedBin& bin : bins_) bin = {};
    count_ = {};
    paged_ = false;
    memory_.reset();
}

void CachedTile::dropPages() {
    for (CachedBin& bin : bins_) bin.base.clear();
    paged_ = false;
}

std::size_t CachedTile::computePeriod(const Receivers& receivers, const WallCache& walls,
                                      const BinnedSun& binned, Progress& progress,
                                      const std::stop_token& stop) {
    const std::size_t swept = sweep(receivers, walls, binned, progress, stop);
    count_.computePeriod(blocks_, bins_, binned, stop);
    return swept;
}

// `wasOverhanging`: whether a removed building had overhangs.
void CachedTile::lookAtGround(const Receivers& receivers, const WallCache& walls, bool wasOverhanging) {
    const double datumM = walls.list().datumM;
    grounds_ = BlockGrounds(receivers, blocks_, datumM);
    if (walls.overhangs().empty() && !wasOverhanging) return;
    if (overhangs_.numbers.empty() || !receivers.flat())
        overhangs_ = OverhangTile(receivers, blocks_, datumM);
}

struct CachedTile::Sweeping {
    const WallCache& walls;
    double cellM;
    const std::stop_token& stop;
    struct Memory {
        TileSweep tiles;
        OverhangSweep overhangs;
        std::vector<HorizonCode> horizons;
        OverhangList list;
    };
    tbb::enumerable_thread_specific<Memory> memory{};
};

std::size_t CachedTile::sweep(const Receivers& receivers, const WallCache& walls, const BinnedSun& binned,
                              Progress& progress, const std::stop_token& stop) {
    std::vector<AzimuthBin> missing;
    for (const AzimuthBin& bin : binned.bins)
        if (!bins_[bin.number].holds(bin)) missing.push_back({bin.number, bin.away, {CachedBin::below(bin)}});
    if (missing.empty()) return 0;
    dropPages();
    known_ = CachedCells(blocks_);
    lookAtGround(receivers, walls, false);
    Sweeping sweeping{walls, receivers.grid.cellM, stop};
    std::atomic<std::size_t> done{0};
    const std::vector<BatchRange> batches = groupIntoBatches(makeSweptBins(missing));
    tbb::parallel_for(std::size_t{0}, batches.size(), [&](std::size_t i) {
        if (stop.stop_requested()) return;
        sweep(std::span(missing).subspan(batches[i].first, batches[i].size()), sweeping);
        progress.report(double(++done) / double(batches.size()), NM_TEXT("sweeping horizons"));
    });
    return missing.size();
}

// `missing`: the bins of one batch.
void CachedTile::sweep(std::span<const AzimuthBin> missing, Sweeping& sweeping) {
    std::vector<SweptBin> swept = makeSweptBins(missing);
    for (std::size_t i = 0; i < swept.size(); ++i) {
        CachedBin& cached = bins_[missing[i].number];
        cached.lowest = cached.codes.empty() ? swept[i].lowest : std::min(cached.lowest, swept[i].lowest);
        cached.codes.resize(blocks_.numbers());
        swept[i].lowest = cached.lowest;
    }
    const auto take = [&](std::size_t bin, std::size_t block, const HorizonCode* swept, bool swapped) {
        writeBlock(swept, blocks_, blocks_.blocks()[block], swapped, bins_[missing[bin].number].codes.data());
    };
    sweeping.memory.local().tiles.run({sweeping.walls.list(), blocks_, grounds_, sweeping.cellM}, swept, take,
                                      sweeping.stop);
    for (const AzimuthBin& bin : missing) findGaps(bins_[bin.number], bin.away, sweeping);
}

void CachedTile::findGaps(CachedBin& cached, glm::dvec2 away, Sweeping& sweeping) const {
    const WallCache& walls = sweeping.walls;
    Sweeping::Memory& memory = sweeping.memory.local();
    if (!walls.overhangs().empty() && !sweeping.stop.stop_requested()) {
        const ShadowAxes axes(away);
        walls.overhangs().across(axes, extentOf(box_, axes), toTangent(cached.lowest),
                                 axes.alongPerDistance / sweeping.cellM, memory.list);
        const auto gaps =
            memory.overhangs.intervals({memory.list, overhangs_, away, cached.lowest, sweeping.cellM},
                                       ofReceivers(blocks_, cached.codes, memory.horizons), sweeping.stop);
        cached.gaps.assign(gaps.begin(), gaps.end());
    }
    if (sweeping.stop.stop_requested()) cached = {};
}

/// One per thread.
struct CachedTile::EditMemory {
    struct Own {
        BinEdit codes;
        GapEdit gaps;
        TileSteps steps;
    };
    explicit EditMemory(std::size_t numbers) : own([numbers] { return Own{{}, {}, TileSteps(numbers)}; }) {}
    tbb::enumerable_thread_specific<Own> own;
};

struct CachedTile::Editing {
    TileEdit edit;
    const SunsByNumber& suns;
    const HiddenByNumber& hidden;  ///< empty if there are no overhangs
    double binDeg;
    EditMemory& memory;
};

CachedTile::CachedTile(CachedTile&&) noexcept = default;
CachedTile& CachedTile::operator=(CachedTile&&) noexcept = default;
CachedTile::~CachedTile() = default;

// If the pages do not match the removed buildings, the horizons below them are unknown.
ChangedReceivers CachedTile::update(const Receivers& receivers, std::span<const std::uint32_t> cells,
                                    bool undoesLast) {
    if (!undoesLast) known_ = CachedCells(blocks_);
    return noonmark::update(blocks_, known_, receivers, cells);
}

void CachedTile::change(const Receivers& receivers, std::span<const std::uint32_t> cells,
                        const WallCache& walls, const WallChange& change, CountedPeriod& period,
                        double binDeg, const std::stop_token& stop) {
    const bool undoesLast = change.undoesLast && paged_ && receivers.flat();
    const bool isOverhanging = !walls.overhangs().empty() || !change.removed.overhangs.empty();
    const ChangedReceivers changed = update(receivers, cells, undoesLast);
    if (bytes() == 0) return;
    if (!undoesLast) dropPages();
    if (!receivers.flat() || isOverhanging) lookAtGround(receivers, walls, !change.removed.overhangs.empty());
    count_.beginNew(blocks_, changed.newNumbers);
    if (!memory_) memory_ = std::make_unique<EditMemory>(blocks_.numbers());
    const HiddenByNumber none;
    Editing editing{{walls, change, blocks_, known_, grounds_, overhangs_, changed, undoesLast,
                     receivers.flat(), isOverhanging, receivers.grid.columns, receivers.grid.cellM, stop},
                    period.suns(bins_.size()),
                    isOverhanging ? period.hidden(bins_.size()) : none,
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

// The sums do not include bins that the period does not visit.
void CachedTile::change(std::uint32_t number, Editing& editing) {
    CachedBin& bin = bins_[number];
    EditMemory::Own& memory = editing.memory.own.local();
    const glm::dvec2 away = computeMiddleDirection(number, editing.binDeg);
    const auto changes = memory.codes.run(editing.edit, away, bin, editing.suns[number], memory.steps);
    if (!editing.edit.isOverhanging) return;
    const GapEdit::Bin now{away, bin.lowest, bin.codes, changes, editing.hidden[number]};
    for (const GapChange& change : memory.gaps.run(editing.edit, now, bin.gaps))
        memory.steps.add(change.number, change.added);
}

void CachedTile::writeGross(ShadowField& field, const std::stop_token& stop) {
    count_.writeGross(blocks_, field, stop);
}

void CachedTile::writeRuns(const BinnedSun& binned, const RunCount& count, ShadowField& field,
                           const std::stop_token& stop) {
    count_.writeRuns(blocks_, bins_, binned, count, field, stop);
}

}  // namespace noonmark
