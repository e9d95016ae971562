#include "core/engines/projected/masks/projected_masks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <iterator>

namespace noonmark {

namespace {

constexpr std::size_t cellsAReceiver = 3;  // in a dense window at most
constexpr int smallSide = 96;              // not worth dividing further, cells
constexpr int maxSide = 192;               // so that eight rasters of a window take some 50 kB at most

struct Cell {
    int column, row;
    std::uint32_t index;
};

struct Bounds {
    int west = 1 << 30, east = -1, south = 1 << 30, north = -1;  // inclusive
    void add(const Cell& cell) {
        west = std::min(west, cell.column);
        east = std::max(east, cell.column);
        south = std::min(south, cell.row);
        north = std::max(north, cell.row);
    }
    [[nodiscard]] int columns() const { return east - west + 1; }
    [[nodiscard]] int rows() const { return north - south + 1; }
};

// `cells` in row-major order.
ReceiverBlock blockOf(const std::vector<Cell>& cells, const Bounds& box) {
    ReceiverBlock window{box.west, box.east + 1, {box.south, box.north + 1}, {}};
    for (const Cell& cell : cells) {
        auto& runs = window.runs;
        if (!runs.empty() && runs.back().row == cell.row &&
            runs.back().column + runs.back().count == cell.column)
            ++runs.back().count;
        else
            runs.push_back({cell.column, cell.row, 1, cell.index});
    }
    return window;
}

bool isBlock(std::size_t cells, const Bounds& box) {
    const int side = std::max(box.columns(), box.rows());
    const std::size_t all = std::size_t(box.columns()) * std::size_t(box.rows());
    return side <= smallSide || (side <= maxSide && all <= cellsAReceiver * cells);
}

void divide(std::vector<Cell> cells, std::vector<ReceiverBlock>& windows) {
    if (cells.empty()) return;
    Bounds box;
    for (const Cell& cell : cells) box.add(cell);
    if (isBlock(cells.size(), box)) return windows.push_back(blockOf(cells, box));
    const bool wide = box.columns() >= box.rows();
    const int middle = wide ? box.west + box.columns() / 2 : box.south + box.rows() / 2;
    const auto isLow = [&](const Cell& cell) { return (wide ? cell.column : cell.row) < middle; };
    std::vector<Cell> high;
    std::ranges::copy_if(cells, std::back_inserter(high), std::not_fn(isLow));
    std::erase_if(cells, std::not_fn(isLow));
    divide(std::move(cells), windows);
    divide(std::move(high), windows);
}

}  // namespace

std::vector<ReceiverBlock> divideIntoBlocks(const Receivers& receivers) {
    const auto columns = std::uint32_t(receivers.grid.columns);
    std::vector<Cell> cells;
    cells.reserve(receivers.cells.size());
    for (std::uint32_t i = 0; i < receivers.cells.size(); ++i)
        cells.push_back({int(receivers.cells[i] % columns), int(receivers.cells[i] / columns), i});
    std::vector<ReceiverBlock> windows;
    divide(std::move(cells), windows);
    return windows;
}

std::vector<std::uint64_t> rasterWithoutReceivers(const ReceiverBlock& window) {
    const BitLayout layout = window.layout();
    std::vector<std::uint64_t> raster(layout.words(), ~std::uint64_t{0});
    for (const ReceiverRun& run : window.runs)
        for (int column = run.column; column < run.column + run.count; ++column)
            raster[layout.word(column, run.row - window.band.first)] &= ~(std::uint64_t{1} << (column & 63));
    return raster;
}

namespace {

// Casters that are filled between two looks at what is still lit.
constexpr std::size_t castersALook = 16;
// Casters that are tested for reach at once.
constexpr std::size_t castersATest = 32;

/// A rectangle of receivers, in cells; both ends are centres of cells.
struct CellBox {
    glm::dvec2 low{}, high{};
    bool empty = true;
};

CellBox boxOf(const ReceiverBlock& window) {
    return {{double(window.west), double(window.band.first)},
            {double(window.east - 1), double(window.band.end - 1)},
            false};
}

// Bounds of the receivers that are lit at some step.
CellBox findLit(const std::vector<StepWords>& rasters, const ReceiverBlock& window) {
    const BitLayout layout = window.layout();
    int west = layout.wordColumns, east = -1, south = layout.rows, north = -1;
    for (int column = 0; column < layout.wordColumns; ++column) {
        const StepWords* words = &rasters[std::size_t(column) * std::size_t(layout.rows)];
        for (int row = 0; row < layout.rows; ++row) {
            std::uint64_t all = ~std::uint64_t{0};
            for (const std::uint64_t step : words[row].words) all &= step;
            if (all == ~std::uint64_t{0}) continue;
            west = std::min(west, column);
            east = column;
            south = std::min(south, row);
            north = std::max(north, row);
        }
    }
    if (east < 0) return {};
    const int first = layout.firstColumn();
    return {{double(std::max(window.west, first + west * 64)), double(window.band.first + south)},
            {double(std::min(window.east - 1, first + east * 64 + 63)), double(window.band.first + north)},
            false};
}

// The bits [column, column + 64) of a row, at eight steps.
StepWords bitsFrom(const std::vector<StepWords>& rasters, const BitLayout& layout, int column, int row) {
    const auto shift = unsigned(column & 63);
    StepWords bits = rasters[layout.word(column, row)];
    for (std::uint64_t& step : bits.words) step >>= shift;
    if (shift == 0 || (column >> 6) + 1 >= layout.firstWord + layout.wordColumns) return bits;
    const StepWords& east = rasters[layout.word(column + 64, row)];
    for (std::size_t step = 0; step < stepsTogether; ++step)
        bits.words[step] |= east.words[step] << (64 - shift);
    return bits;
}

void putBits(std::span<std::uint64_t> words, std::uint32_t first, std::uint64_t bits) {
    const unsigned shift = first & 63U;
    words[first >> 6U] |= bits << shift;
    if (shift != 0 && bits >> (64 - shift) != 0) words[(first >> 6U) + 1] |= bits >> (64 - shift);
}

void write(const std::vector<StepWords>& rasters, const ReceiverBlock& window, std::size_t first,
           StepMasks& masks) {
    const BitLayout layout = window.layout();
    const std::size_t steps = std::min(stepsTogether, masks.steps - first);
    std::array<std::span<std::uint64_t>, stepsTogether> rows;
    for (std::size_t step = 0; step < steps; ++step) rows[step] = masks.at(first + step);
    for (const ReceiverRun& run : window.runs)
        for (int done = 0; done < run.count; done += 64) {
            const std::uint64_t among = ~std::uint64_t{0} >> unsigned(64 - std::min(64, run.count - done));
            const StepWords bits = bitsFrom(rasters, layout, run.column + done, run.row - window.band.first);
            for (std::size_t step = 0; step < steps; ++step)
                putBits(rows[step], run.first + std::uint32_t(done), bits.words[step] & among);
        }
}

BlockPlan::Groups groupsInReach(const CasterGroups& groups, const CellBox& box, const CasterReach& reach) {
    BlockPlan::Groups inReach = groups.nearestFirst(box.low, box.high);
    std::erase_if(inReach, [&](std::uint32_t group) { return !groups.mayTouch(group, reach); });
    return inReach;
}

}  // namespace

BlockPlan::BlockPlan(ReceiverBlock where, const CityCasters& casters, const CasterReach& period)
    : window(std::move(where)), empty(rasterWithoutReceivers(window)) {
    const CellBox box = boxOf(window);
    CasterReach reach = period;
    reach.aimAt(box.low, box.high);
    common = groupsInReach(casters.common, box, reach);
    for (const CasterGroups& groups : casters.own) own.push_back(groupsInReach(groups, box, reach));
}

BlockFiller::BlockFiller(const CityCasters& casters)
    : common_(casters.common), own_(casters.own.begin(), casters.own.end()) {}

void BlockFiller::Layer::choose(const BlockPlan& plan, const BlockPlan::Groups& among,
                                const CasterReach& steps) {
    const CellBox box = boxOf(plan.window);
    CasterReach reach = steps;
    reach.aimAt(box.low, box.high);
    near.clear();
    for (const std::uint32_t group : among) {
        if (!groups->mayTouch(group, reach)) continue;
        const std::size_t end = groups->endOf(group);
        for (std::size_t first = groups->firstOf(group); first < end; first += castersATest) {
            const std::size_t count = std::min(castersATest, end - first);
            const std::uint64_t touching = reach.touching(groups->extents(), first, count);
            if (touching != 0) near.push_back({first, count, touching});
        }
    }
}

void BlockFiller::aimAt(const BlockPlan& plan, const CasterReach& reach) {
    plan_ = &plan;
    common_.choose(plan, plan.common, reach);
    for (std::size_t city = 0; city < own_.size(); ++city) own_[city].choose(plan, plan.own[city], reach);
}

bool BlockFiller::fillLayer(Layer& layer, const CasterReach& steps, Rasters& rasters) {
    const std::span words(rasters.data()->words, rasters.size() * stepsTogether);
    const ReceiverBlock& window = plan_->window;
    bool any = false;
    CasterReach reach = steps;
    CellBox lit = boxOf(window);
    reach.aimAt(lit.low, lit.high);
    const auto fillChosen = [&] {
        if (chosen_.empty()) return;
        layer.fill.fill(chosen_, reach.offsets(), window.layout(), window.band, words);
        chosen_.clear();
        any = true;
        lit = findLit(rasters, window);
        if (!lit.empty) reach.aimAt(lit.low, lit.high);
    };
    const CasterGroups& all = *layer.groups;
    for (const CasterBlock& block : layer.near) {
        for (std::uint64_t touching = block.casters & reach.touching(all.extents(), block.first, block.count);
             touching != 0; touching &= touching - 1)
            chosen_.push_back(all.indices()[block.first + std::size_t(std::countr_zero(touching))]);
        if (chosen_.size() >= castersALook) fillChosen();
        if (lit.empty) break;
    }
    fillChosen();
    return any;
}

void BlockFiller::fill(const CasterReach& reach, std::size_t first, std::span<StepMasks> masks) {
    shared_.resize(plan_->empty.size());
    for (std::size_t word = 0; word < shared_.size(); ++word)
        std::ranges::fill(shared_[word].words, plan_->empty[word]);
    const bool common = fillLayer(common_, reach, shared_);
    for (std::size_t city = 0; city < masks.size(); ++city) {
        if (own_[city].near.empty()) {
            if (common) write(shared_, plan_->window, first, masks[city]);
            continue;
        }
        rasters_ = shared_;
        const bool own = fillLayer(own_[city], reach, rasters_);
        if (common || own) write(rasters_, plan_->window, first, masks[city]);
    }
}

}  // namespace noonmark
