#include "core/engines/projected/masks/window_filler.h"

#include <algorithm>

namespace noonmark {

namespace {

// Casters that are filled between two looks at what is still lit.
constexpr std::size_t castersALook = 16;

/// A rectangle of receivers, in cells; both ends are centres of cells.
struct CellBox {
    glm::dvec2 low{}, high{};
    bool empty = true;
};

CellBox boxOf(const ReceiverWindow& window) {
    return {{double(window.west), double(window.band.first)},
            {double(window.east - 1), double(window.band.end - 1)},
            false};
}

// Bounds of the receivers that are lit at some step.
CellBox findLit(const std::vector<StepWords>& rasters, const ReceiverWindow& window) {
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

// The bits [column, column + 64) of a row, at one step.
std::uint64_t bitsFrom(const std::vector<StepWords>& rasters, const BitLayout& layout, int column, int row,
                       std::size_t step) {
    const auto shift = unsigned(column & 63);
    const std::uint64_t low = rasters[layout.word(column, row)].words[step] >> shift;
    if (shift == 0 || (column >> 6) + 1 >= layout.firstWord + layout.wordColumns) return low;
    return low | rasters[layout.word(column + 64, row)].words[step] << (64 - shift);
}

void putBits(std::span<std::uint64_t> words, std::uint32_t first, std::uint64_t bits) {
    const unsigned shift = first & 63U;
    words[first >> 6U] |= bits << shift;
    if (shift != 0 && bits >> (64 - shift) != 0) words[(first >> 6U) + 1] |= bits >> (64 - shift);
}

void write(const std::vector<StepWords>& rasters, const ReceiverWindow& window, std::size_t first,
           StepMasks& masks) {
    const BitLayout layout = window.layout();
    const std::size_t steps = std::min(stepsTogether, masks.steps - first);
    for (std::size_t step = 0; step < steps; ++step) {
        const std::span<std::uint64_t> words = masks.at(first + step);
        for (const ReceiverRun& run : window.runs)
            for (int done = 0; done < run.count; done += 64) {
                const std::uint64_t among =
                    ~std::uint64_t{0} >> unsigned(64 - std::min(64, run.count - done));
                putBits(
                    words, run.first + std::uint32_t(done),
                    bitsFrom(rasters, layout, run.column + done, run.row - window.band.first, step) & among);
            }
    }
}

WindowPlan::Groups groupsInReach(const CasterGroups& groups, const CellBox& box, const CasterReach& reach) {
    WindowPlan::Groups inReach = groups.nearestFirst(box.low, box.high);
    std::erase_if(inReach, [&](std::uint32_t group) { return !reach.touches(groups.enclosing(group)); });
    return inReach;
}

bool mayReach(const CasterGroups& groups, const WindowPlan::Groups& some, const ReceiverWindow& window,
              const CasterReach& steps) {
    if (some.empty()) return false;
    const CellBox box = boxOf(window);
    CasterReach reach = steps;
    reach.aimAt(box.low, box.high);
    return std::ranges::any_of(some,
                               [&](std::uint32_t group) { return reach.touches(groups.enclosing(group)); });
}

}  // namespace

WindowPlan::WindowPlan(ReceiverWindow where, const CityCasters& casters, const CasterReach& period)
    : window(std::move(where)), empty(rasterWithoutReceivers(window)) {
    const CellBox box = boxOf(window);
    CasterReach reach = period;
    reach.aimAt(box.low, box.high);
    common = groupsInReach(casters.common, box, reach);
    for (const CasterGroups& groups : casters.own) own.push_back(groupsInReach(groups, box, reach));
}

WindowFiller::WindowFiller(const CityCasters& casters)
    : common_(casters.common), own_(casters.own.begin(), casters.own.end()) {}

bool WindowFiller::fillLayer(Layer& layer, const WindowPlan& plan, const WindowPlan::Groups& groups,
                             const CasterReach& steps, Rasters& rasters) {
    const std::span words(rasters.data()->words, rasters.size() * stepsTogether);
    bool any = false;
    CasterReach reach = steps;
    CellBox lit = boxOf(plan.window);
    reach.aimAt(lit.low, lit.high);
    const auto fillChosen = [&] {
        if (chosen_.empty()) return;
        layer.fill.fill(chosen_, reach.offsets(), plan.window.layout(), plan.window.band, words);
        chosen_.clear();
        any = true;
        lit = findLit(rasters, plan.window);
        if (!lit.empty) reach.aimAt(lit.low, lit.high);
    };
    for (const std::uint32_t group : groups) {
        if (!reach.touches(layer.groups->enclosing(group))) continue;
        for (const std::uint32_t caster : layer.groups->of(group)) {
            if (!reach.touches(layer.groups->casters().casters[caster])) continue;
            chosen_.push_back(caster);
            if (chosen_.size() == castersALook) fillChosen();
            if (lit.empty) return any;
        }
    }
    fillChosen();
    return any;
}

void WindowFiller::fill(const WindowPlan& plan, const CasterReach& reach, std::size_t first,
                        std::span<StepMasks> masks) {
    shared_.resize(plan.empty.size());
    for (std::size_t word = 0; word < shared_.size(); ++word)
        std::ranges::fill(shared_[word].words, plan.empty[word]);
    const bool common = fillLayer(common_, plan, plan.common, reach, shared_);
    for (std::size_t city = 0; city < masks.size(); ++city) {
        if (!mayReach(*own_[city].groups, plan.own[city], plan.window, reach)) {
            if (common) write(shared_, plan.window, first, masks[city]);
            continue;
        }
        rasters_ = shared_;
        const bool own = fillLayer(own_[city], plan, plan.own[city], reach, rasters_);
        if (common || own) write(rasters_, plan.window, first, masks[city]);
    }
}

}  // namespace noonmark
