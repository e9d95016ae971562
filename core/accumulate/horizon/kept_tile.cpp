#include "core/accumulate/horizon/kept_tile.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>

#include "core/accumulate/horizon/bin_edit.h"

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

void markReceivers(const std::vector<ReceiverBlocks::Masks>& rows, const ReceiverBlocks& blocks,
                   std::vector<std::uint8_t>& parts) {
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t line = 0; line < rows[i].size(); ++line)
            if (rows[i][line] != 0)
                parts[(blocks.blocks()[i].first + line * ReceiverBlocks::side) / lanesARun] = 1;
}

bool hasReceivers(const ReceiverBlocks& blocks, std::size_t part) {
    const std::size_t end = std::min((part + 1) * lanesARun, blocks.numbers());
    for (std::size_t number = part * lanesARun; number < end; ++number)
        if (blocks.cell(number) != ReceiverBlocks::padding) return true;
    return false;
}

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
}

std::size_t KeptTile::retime(const KeptWalls& walls, double cellM, const BinnedSun& binned,
                             const PeriodCount& count, const std::stop_token& stop) {
    std::atomic<std::size_t> swept{0};
    using Sums = std::vector<std::uint32_t>;
    tbb::enumerable_thread_specific<Sums> sums{[&] { return Sums(blocks_.numbers()); }};
    tbb::enumerable_thread_specific<SquareSweep> sweeps;
    tbb::parallel_for(std::size_t{0}, binned.bins.size(), [&](std::size_t i) {
        if (stop.stop_requested()) return;
        const AzimuthBin& bin = binned.bins[i];
        KeptBin& kept = bins_[bin.number];
        if (!kept.holds(bin)) {
            kept.lowest = kept.codes.empty() ? bin.lowest() : std::min(kept.lowest, bin.lowest());
            kept.codes.resize(blocks_.numbers());
            sweepBin(sweeps.local(), walls.list(), blocks_, {}, bin.away, kept.lowest, cellM, kept.codes,
                     stop);
            if (stop.stop_requested()) kept = {};
            ++swept;
        }
        count.addHidden(i, kept.codes, sums.local());
    });
    count_.hidden.assign(blocks_.numbers(), 0);
    for (const Sums& some : sums)
        std::ranges::transform(count_.hidden, some, count_.hidden.begin(), std::plus<>());
    return swept;
}

void KeptTile::change(const Receivers& receivers, const KeptWalls& walls, const WallChange& change,
                      const BinnedSun& binned, const PeriodCount* count, double binDeg,
                      const std::stop_token& stop) {
    ReceiverBlocks now(receivers, box_, Numbering::cells);
    TileEdit edit{
        walls, change, now, added(now, blocks_, false), added(now, blocks_, true), {}, receivers.grid.cellM};
    for (std::size_t i = 0; i < edit.newRows.size(); ++i)
        if (edit.newRows[i] != ReceiverBlocks::Masks{}) edit.newBlocks.push_back(i);
    count_.changed.assign(partsOf(now), 0);
    markReceivers(edit.newRows, now, count_.changed);
    std::vector<const HiddenSuns*> hidden(bins_.size(), nullptr);
    for (std::size_t i = 0; count != nullptr && i < binned.bins.size(); ++i)
        hidden[binned.bins[i].number] = &count->hidden(i);
    tbb::enumerable_thread_specific<BinEdit> edits;
    tbb::parallel_for(std::size_t{0}, bins_.size(), [&](std::size_t number) {
        KeptBin& bin = bins_[number];
        if (bin.codes.empty() || stop.stop_requested()) return;
        const auto note = [&](std::uint32_t at, HorizonCode before, HorizonCode after) {
            if (hidden[number] == nullptr) return;
            const std::uint32_t more = (*hidden[number])(after) - (*hidden[number])(before);
            if (more == 0) return;
            std::atomic_ref(count_.hidden[at]).fetch_add(more, std::memory_order_relaxed);
            std::atomic_ref(count_.changed[at / lanesARun]).store(1, std::memory_order_relaxed);
        };
        edits.local().run(edit, middleAway(std::uint32_t(number), binDeg), bin.lowest, bin.codes, note);
    });
    blocks_ = std::move(now);
    if (stop.stop_requested()) drop();
}

void KeptTile::write(const BinnedSun& binned, const PeriodCount& count, ShadowField& field, bool all,
                     const std::stop_token& stop) {
    BinCodes codes;
    for (const AzimuthBin& bin : binned.bins) codes.push_back(bins_[bin.number].codes);
    tbb::enumerable_thread_specific<std::vector<RunLanes>> lanes;
    tbb::parallel_for(std::size_t{0}, partsOf(blocks_), [&](std::size_t part) {
        if (stop.stop_requested() || !(all || count_.changed[part] != 0)) return;
        if (!hasReceivers(blocks_, part)) return;
        writeMinutes(blocks_, part, count_.hidden, count.longestRuns(codes, part, lanes.local()), field);
    });
}

}  // namespace noonmark
