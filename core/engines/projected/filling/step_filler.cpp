#include "core/engines/projected/filling/step_filler.h"

#include <cmath>
#include <glm/common.hpp>
#include <numeric>

namespace noonmark {

inline bool CasterRing::isFar(std::size_t edge, const StepOffsets& throws, std::size_t step) const {
    return throws.at.x[step] * edges[edge].along.y - throws.at.y[step] * edges[edge].along.x > 0;
}

EdgeArc CasterRing::findFar(const StepOffsets& throws, std::size_t step) const {
    const std::size_t count = edges.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!isFar(i, throws, step) || isFar(before(i), throws, step)) continue;
        std::size_t end = after(i);
        while (isFar(end, throws, step)) end = after(end);
        return {.first = std::uint32_t(i), .end = std::uint32_t(end)};
    }
    return {};
}

void CasterRing::bound(EdgeArc& arc) const {
    arc.low = arc.high = points[arc.end];
    std::size_t i = arc.first;
    do {
        arc.low = glm::min(arc.low, points[i]);
        arc.high = glm::max(arc.high, points[i]);
        i = after(i);
    } while (i != arc.end);
}

FarEdges CasterRing::facingApart(const EdgeArc& far) const {
    FarEdges kept{far, {.first = far.end, .end = far.first}, {}};
    if (far.first == far.end)  // all are near: begins at the lowest point, so that each side runs only
                               // upwards or only downwards
        kept.near.first = kept.near.end =
            std::uint32_t(std::ranges::min_element(points, {}, &glm::dvec2::y) - points.begin());
    bound(kept.far);
    bound(kept.near);
    kept.chord = RingEdge(points[far.end], points[far.first]);
    return kept;
}

namespace {

constexpr int wordsABand = 1536, minRows = 64, bandsAGrid = 8;
constexpr int gapColumns = 256;      // between windows of a band
constexpr std::size_t sparsity = 3;  // windows are used where they leave out two thirds of the grid

/// Calls `visit(column, row)` for each receiver of a band.
template <class Visit>
void forReceivers(const Receivers& receivers, const RowBand& band, const Visit& visit) {
    const auto columns = std::uint32_t(receivers.grid.columns);
    const auto first = std::ranges::lower_bound(receivers.cells, std::uint32_t(band.first) * columns);
    for (auto cell = first; cell != receivers.cells.end() && *cell < std::uint32_t(band.end) * columns;
         ++cell)
        visit(int(*cell % columns), int(*cell / columns));
}

std::vector<std::uint64_t> rasterOfNoReceivers(const Receivers& receivers, const FillWindow& window) {
    const BitLayout layout = window.layout();
    std::vector<std::uint64_t> raster(layout.words(), ~std::uint64_t{0});
    forReceivers(receivers, window.band, [&](int column, int row) {
        if (column >= window.west && column < window.east)
            raster[layout.word(column, row - window.band.first)] &= ~(std::uint64_t{1} << (column & 63));
    });
    return raster;
}

std::vector<RowBand> bandsOf(const Grid& grid) {
    const int wordColumns = (grid.columns + 63) / 64,
              rows = std::max(minRows, std::min(wordsABand / wordColumns, grid.rows / bandsAGrid));
    std::vector<RowBand> bands;
    for (int first = 0; first < grid.rows; first += rows)
        bands.push_back({first, std::min(first + rows, grid.rows)});
    return bands;
}

// Words beside each other, or nearly so, share a window: each one tests all casters.
std::vector<FillWindow> windowsIn(const Receivers& receivers, const RowBand& band) {
    const int end = receivers.grid.columns;
    std::vector<bool> used(std::size_t(end + 63) / 64);
    forReceivers(receivers, band, [&](int column, int) { used[std::size_t(column) / 64] = true; });
    std::vector<FillWindow> windows;
    for (int word = 0; word < int(used.size()); ++word) {
        if (!used[std::size_t(word)]) continue;
        const int west = word * 64, east = std::min(west + 64, end);
        if (windows.empty() || west - windows.back().east > gapColumns)
            windows.push_back({band, west, east});
        else
            windows.back().east = east;
    }
    return windows;
}

std::size_t countWords(const std::vector<FillWindow>& windows) {
    std::size_t words = 0;
    for (const FillWindow& window : windows) words += window.layout().words();
    return words;
}

}  // namespace

FillCount& FillCount::operator+=(const FillCount& other) {
    rows += other.rows;
    outOfReach += other.outOfReach;
    return *this;
}

StepFiller::StepFiller(const ShadowCasters& casters, const ReceiverCount& where, const Receivers& receivers,
                       const SunSteps& sun, const FillWindow& window)
    : casters_(casters),
      where_(where),
      sun_(sun),
      band_(window.band),
      layout_(window.layout()),
      cellM_(receivers.grid.cellM),
      noReceivers_(rasterOfNoReceivers(receivers, window)),
      caster_(casters) {
    Indices all(casters.casters.size());
    std::iota(all.begin(), all.end(), 0U);
    if (!sun.steps.empty()) reach(computeOffsets(sun, cellM_, 0, sun.steps.size()), all, everInReach_);
}

void StepFiller::reach(const StepOffsets& throws, const Indices& among, Indices& inReach) const {
    inReach.clear();
    for (const std::uint32_t i : among) {
        SweptBox box = computeSweptBox(casters_.casters[i], throws);
        box.low.x = std::max(box.low.x, layout_.firstColumn() - 1.0);
        box.high.x = std::min(box.high.x, layout_.columns + 1.0);
        if (box.low.x <= box.high.x && where_.any(box.low, box.high, band_)) inReach.push_back(i);
    }
}

void StepFiller::fill(std::size_t first, std::span<std::uint64_t> rasters) {
    const StepOffsets throws = computeOffsets(sun_, cellM_, first, first + stepsTogether);
    reach(throws, everInReach_, inReach_);
    for (std::size_t word = 0; word < noReceivers_.size(); ++word)
        std::fill_n(&rasters[word * stepsTogether], stepsTogether, noReceivers_[word]);
    count_.rows += caster_.fill(inReach_, throws, layout_, band_, rasters);
    const std::size_t steps = std::min(stepsTogether, sun_.steps.size() - first);
    count_.outOfReach += (casters_.casters.size() - inReach_.size()) * steps;
}

std::vector<FillWindow> windowsOf(const Receivers& receivers) {
    std::vector<FillWindow> all, narrow;
    for (const RowBand& band : bandsOf(receivers.grid)) {
        all.push_back({band, 0, receivers.grid.columns});
        const auto some = windowsIn(receivers, band);
        narrow.insert(narrow.end(), some.begin(), some.end());
    }
    return countWords(narrow) * sparsity < countWords(all) ? narrow : all;
}

WordBox WordBox::with(const WordBox& other) const {
    if (empty()) return other;
    if (other.empty()) return *this;
    return {std::min(west, other.west), std::max(east, other.east), std::min(south, other.south),
            std::max(north, other.north)};
}

BuildingFill::BuildingFill(const BuildingCasters& buildings, const BitLayout& layout, const RowBand& band,
                           const StepOffsets& period)
    : buildings_(buildings),
      layout_(layout),
      band_(band),
      caster_(buildings.casters()),
      raster_(layout.words(), StepWords{}) {
    for (std::size_t i = 0; i < buildings.buildings(); ++i)
        reaches_.push_back(!computeBox(i, period).empty());
}

WordBox BuildingFill::computeBox(std::size_t building, const StepOffsets& throws) const {
    glm::dvec2 low(1e30), high(-1e30);
    for (const std::uint32_t i : buildings_.of(building)) {
        const SweptBox box = computeSweptBox(buildings_.casters().casters[i], throws);
        low = glm::min(low, box.low);
        high = glm::max(high, box.high);
    }
    const auto down = [](double at, int minimum, int maximum) {
        return int(std::floor(std::clamp(at, double(minimum), double(maximum))));
    };
    const int west = down(low.x, 0, layout_.columns), east = down(high.x + 1, 0, layout_.columns);
    return {west >> 6, (east + 63) >> 6, down(low.y, band_.first, band_.end) - band_.first,
            down(high.y + 1, band_.first, band_.end) - band_.first};
}

WordBox BuildingFill::fill(std::size_t building, const StepOffsets& throws) {
    if (!reaches(building)) return {};
    const WordBox box = computeBox(building, throws);
    if (box.empty()) return {};
    const std::span words(raster_.data()->words, raster_.size() * stepsTogether);
    caster_.fill(buildings_.of(building), throws, layout_, band_, words);
    return box;
}

void BuildingFill::clear(const WordBox& box) {
    for (int column = box.west; column < box.east; ++column) {
        StepWords* words = &raster_[std::size_t(column) * std::size_t(layout_.rows)];
        std::fill(words + box.south, words + box.north, StepWords{});
    }
}

}  // namespace noonmark
