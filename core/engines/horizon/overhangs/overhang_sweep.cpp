#include "core/engines/horizon/overhangs/overhang_sweep.h"

#include <algorithm>
#include <cmath>

#include "core/engines/ray/ray_reference.h"

namespace noonmark {

OverhangTile::OverhangTile(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM)
    : box(blocks.box()) {
    if (!receivers.flat()) groundsM.resize(blocks.numbers());
    const glm::ivec2 all = blocks.blockCounts();
    blockNumbers.assign(std::size_t(all.x) * std::size_t(all.y), {0, 0});
    firstOfBlock.assign(blockNumbers.size(), -1);
    for (const ReceiverBlocks::Block& block : blocks.blocks()) {
        const std::size_t index = indexOf(block), first = numbers.size();
        blockNumbers[index] = {block.first, block.first + block.count};
        firstOfBlock[index] = std::int32_t(first);
        numbers.resize(first + ReceiverBlocks::cells, -1);
        const std::uint8_t* places = blocks.places(block, false);
        for (std::uint32_t n = 0; n < block.count; ++n) {
            const int column = block.column - box.firstColumn + places[n] % ReceiverBlocks::side,
                      row = block.row - box.firstRow + places[n] / ReceiverBlocks::side;
            if (column >= box.columns || row >= box.rows) continue;
            const std::uint32_t number = block.first + n, cell = blocks.cell(number);
            numbers[first + places[n]] = std::int32_t(number);
            if (!receivers.flat() && cell != ReceiverBlocks::padding)
                groundsM[number] = float(double(placeRayOrigin(receivers.position(cell)).z) - datumM);
        }
    }
}

namespace {

// One level higher than the actual code, which exceeds rounding; vertical if the block is not behind the
// overhang.
HorizonCode mostAt(double rise, double distance) {
    constexpr int highest = steepnessLevels - 1 + int(noHorizon);
    if (distance <= 0) return HorizonCode(highest);
    return HorizonCode(std::min(int(toHorizonCode(float(rise / (rise + distance)))) + 1, highest));
}

}  // namespace

void OverhangSweep::begin(const OverhangView& view, const std::stop_token& stop) {
    view_.emplace(view);
    axes_ = ShadowAxes(view.away);
    alongPerMetre_ = axes_.alongPerDistance / view.cellM;
    const double lowestTan = toTangent(view.lowest);
    findInReach(lowestTan);
    layers_.set(inReach_, axes_, alongPerMetre_);
    entries_.clear();
    firsts_.assign(view.tile.blockNumbers.size(), -1);
    for (std::uint32_t layer = 0; layer < layers_.all().size() && !stop.stop_requested(); ++layer)
        findBlocks(layer, layers_.all()[layer], lowestTan);
}

std::span<const Gap> OverhangSweep::intervals(const OverhangView& view, std::span<const HorizonCode> horizons,
                                              const std::stop_token& stop) {
    gaps_.clear();
    begin(view, stop);
    for (std::size_t block = 0; block < firsts_.size() && !stop.stop_requested(); ++block) {
        if (firsts_[block] < 0) continue;
        const HorizonCode lowest = lowestIn(block, horizons);
        if (!maySee(block, lowest)) continue;
        const auto first = std::ptrdiff_t(gaps_.size());
        look(block, blockAt(block, horizons), lowest, [&](int cell, HorizonCode low, HorizonCode high) {
            gaps_.push_back({std::uint32_t(numbers_[std::size_t(cell)]), low, high});
        });
        if (axes_.swapped) sortByNumber({gaps_.begin() + first, gaps_.end()});
    }
    if (stop.stop_requested()) gaps_.clear();
    return gaps_;
}

// By the bounds of each building. Far fewer are cut into strips, which costs more.
void OverhangSweep::findInReach(double lowestTan) {
    constexpr double spare = 2;  // cells, wide of what findBlocks() and addBlocks() add
    const TileBox& box = view_->tile.box;
    ShadowExtent tile;
    tile.addBox(axes_, glm::dvec2(box.firstColumn, box.firstRow) - spare,
                glm::dvec2(box.firstColumn + box.columns, box.firstRow + box.rows) +
                    double(ReceiverBlocks::side) + spare);
    inReach_.clear();
    for (const OverhangShapes* shapes : view_->shapes) {
        ShadowExtent extent;
        extent.addBox(axes_, shapes->low, shapes->high);
        const double reach = std::max(0.0, shapes->topM * alongPerMetre_ / lowestTan);
        if (extent.highQ >= tile.lowQ && extent.lowQ <= tile.highQ && extent.lowAlong <= tile.highAlong &&
            extent.highAlong + reach >= tile.lowAlong)
            inReach_.push_back(shapes);
    }
}

// Visits blocks row by row, or column by column if swapped.
void OverhangSweep::findBlocks(std::uint32_t layer, const OverhangLayer& of, double lowestTan) {
    const TileBox& box = view_->tile.box;
    const ShadowExtent& within = view_->within;
    const double lowQ = std::max(of.lowQ, within.lowQ), highQ = std::min(of.highQ, within.highQ);
    if (!(lowQ < highQ)) return;
    const double lowAlong = std::max(of.lowestAlong, within.lowAlong),
                 highAlong = std::min(of.highestAlong + of.highestRise / lowestTan + 1, within.highAlong);
    const int low = axes_.swapped ? box.firstColumn : box.firstRow,
              rows = axes_.swapped ? box.columns : box.rows;
    for (int row = 0; row * ReceiverBlocks::side < rows; ++row) {
        const double one = axes_.sign * (low + row * ReceiverBlocks::side),
                     other = axes_.sign * (low + row * ReceiverBlocks::side + ReceiverBlocks::side - 1);
        const double nearest = std::min(one, other), farthest = std::max(one, other);
        if (farthest < lowAlong || nearest > highAlong) continue;
        const Range across{lowQ + std::min(axes_.k * one, axes_.k * other),
                           highQ + std::max(axes_.k * one, axes_.k * other)};
        addBlocks(layer, row, across, mostAt(of.highestRise, nearest - of.highestAlong));
    }
}

void OverhangSweep::addBlocks(std::uint32_t layer, int row, const Range& across, HorizonCode maximum) {
    const TileBox& box = view_->tile.box;
    const int low = axes_.swapped ? box.firstRow : box.firstColumn,
              count = ((axes_.swapped ? box.rows : box.columns) + ReceiverBlocks::side - 1) /
                      ReceiverBlocks::side;
    const int first = std::max(0, int(std::floor((across.low - low - 1) / ReceiverBlocks::side))),
              last = std::min(count - 1, int(std::floor((across.high - low + 1) / ReceiverBlocks::side)));
    for (int place = first; place <= last; ++place) {
        const std::size_t block = axes_.swapped ? std::size_t(place) * columns() + std::size_t(row)
                                                : std::size_t(row) * columns() + std::size_t(place);
        if (view_->tile.firstOfBlock[block] < 0) continue;
        entries_.push_back({layer, firsts_[block], maximum});
        firsts_[block] = std::int32_t(entries_.size()) - 1;
    }
}

std::size_t OverhangSweep::columns() const {
    return std::size_t((view_->tile.box.columns + ReceiverBlocks::side - 1) / ReceiverBlocks::side);
}

bool OverhangSweep::maySee(std::size_t block, HorizonCode lowest) const {
    std::int32_t i = firsts_[block];
    while (i >= 0 && entries_[std::size_t(i)].maximum < lowest) i = entries_[std::size_t(i)].next;
    return i >= 0;
}

// `blind` if the block has no receivers.
HorizonCode OverhangSweep::lowestIn(std::size_t block, std::span<const HorizonCode> horizons) const {
    const auto [first, end] = view_->tile.blockNumbers[block];
    HorizonCode lowest = blind;
    for (const HorizonCode code : horizons.subspan(first, end - first)) lowest = std::min(lowest, code);
    return lowest;
}

glm::ivec2 OverhangSweep::firstOf(std::size_t block) const {
    const TileBox& box = view_->tile.box;
    return {box.firstColumn + int(block % columns()) * ReceiverBlocks::side,
            box.firstRow + int(block / columns()) * ReceiverBlocks::side};
}

BlockAxes OverhangSweep::axesOf(std::size_t block) const {
    const ShadowAxes::Point first = axes_.from(glm::dvec2(firstOf(block)));
    return {first.q, first.along, float(axes_.k * axes_.sign), float(axes_.sign), float(alongPerMetre_)};
}

// Stores the numbers of the block's cells in numbers_.
ViewingBlock OverhangSweep::blockAt(std::size_t block, std::span<const HorizonCode> horizons) {
    const OverhangTile& tile = view_->tile;
    const std::int32_t first = tile.firstOfBlock[block];
    ViewingBlock at;
    at.groundsM = tile.groundsM.empty() ? nullptr : groundsM_.data();
    for (int cell = 0; cell < ReceiverBlocks::cells; ++cell) {
        const int place =
            axes_.swapped ? cell % ReceiverBlocks::side * ReceiverBlocks::side + cell / ReceiverBlocks::side
                          : cell;
        const std::int32_t number = first < 0 ? -1 : tile.numbers[std::size_t(first + place)];
        numbers_[std::size_t(cell)] = number;
        at.horizons.values[cell] = number < 0 ? blind : horizons[std::size_t(number)];
        if (at.groundsM != nullptr)
            groundsM_[std::size_t(cell)] = number < 0 ? 0 : tile.groundsM[std::size_t(number)];
    }
    return at;
}

void BatchOverhangs::begin(std::span<const OverhangShapes* const> shapes, const OverhangTile& tile,
                           std::span<const SweptBin> bins, double cellM, const std::stop_token& stop) {
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
        const auto [away, lowest] = bins[bin];
        lowest_[bin] = lowest;
        sweeps_[bin].begin({.shapes = shapes, .tile = tile, .away = away, .lowest = lowest, .cellM = cellM},
                           stop);
    }
}

std::size_t BatchOverhangs::placeOf(const ReceiverBlocks& blocks, std::size_t block) {
    const ReceiverBlocks::Block& of = blocks.blocks()[block];
    const TileBox& box = blocks.box();
    return std::size_t((of.row - box.firstRow) / ReceiverBlocks::side) * std::size_t(blocks.blockCounts().x) +
           std::size_t((of.column - box.firstColumn) / ReceiverBlocks::side);
}

void BatchOverhangs::setBlock(const SweptBlock& swept, const ReceiverBlocks& blocks,
                              const BlockGrounds& grounds) {
    if (swept.codes == nullptr)
        std::ranges::fill(codes_.values, noHorizon);
    else
        std::copy_n(swept.codes, ReceiverBlocks::cells, codes_.values);
    from_.horizons = codes_;
    setOthers(blocks.masks(swept.block, swept.swapped), ViewingBlock::blind, from_.horizons);
    const CacheLine<float>* groundsM = grounds.of(swept.block, swept.swapped).rowsM;
    from_.groundsM = groundsM == nullptr ? nullptr : groundsM->values;
}

}  // namespace noonmark
