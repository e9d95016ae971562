#include "core/accumulate/projected/step_filler.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numeric>

#include "core/accumulate/projected/cell_coordinates.h"

namespace noonmark {

namespace {

constexpr int wordsABand = 1536, leastRows = 64, bandsAGrid = 8;

std::vector<std::uint64_t> rasterOfNoReceivers(const Receivers& receivers, const BitLayout& layout,
                                               const RowBand& band) {
    std::vector<std::uint64_t> raster(layout.words(), ~std::uint64_t{0});
    const auto columns = std::uint32_t(layout.columns);
    const auto first = std::ranges::lower_bound(receivers.cells, std::uint32_t(band.first) * columns);
    for (auto cell = first; cell != receivers.cells.end() && *cell < std::uint32_t(band.end) * columns;
         ++cell) {
        const int column = int(*cell % columns), row = int(*cell / columns) - band.first;
        raster[layout.word(column, row)] &= ~(std::uint64_t{1} << (column & 63));
    }
    return raster;
}

}  // namespace

FillCount& FillCount::operator+=(const FillCount& other) {
    rows += other.rows;
    outOfReach += other.outOfReach;
    return *this;
}

StepFiller::StepFiller(const ShadowCasters& casters, const ReceiverCount& where, const Receivers& receivers,
                       const SunSteps& sun, const RowBand& band)
    : casters_(casters),
      where_(where),
      sun_(sun),
      band_(band),
      layout_(receivers.grid.columns, band.rows()),
      cellM_(receivers.grid.cellM),
      noReceivers_(rasterOfNoReceivers(receivers, layout_, band)),
      caster_(casters) {
    Indices all(casters.casters.size());
    std::iota(all.begin(), all.end(), 0U);
    if (!sun.steps.empty()) reach(throwsOf(0, sun.steps.size()), all, everInReach_);
}

// The throws of some steps, the last one again for lanes beyond, and the bounds of all.
StepThrows StepFiller::throwsOf(std::size_t first, std::size_t end) const {
    StepThrows throws{{}, glm::dvec2(1e30), glm::dvec2(-1e30)};
    for (std::size_t step = first; step < std::max(end, first + stepsTogether); ++step) {
        const glm::dvec3 sun(sun_.steps[std::min(step, sun_.steps.size() - 1)].direction);
        const glm::dvec2 thrown = throwInCells(sun, cellM_);
        throws.low = glm::min(throws.low, thrown);
        throws.high = glm::max(throws.high, thrown);
        if (step - first >= stepsTogether) continue;
        throws.at.x[step - first] = thrown.x;
        throws.at.y[step - first] = thrown.y;
    }
    return throws;
}

void StepFiller::reach(const StepThrows& throws, const Indices& among, Indices& inReach) const {
    inReach.clear();
    for (const std::uint32_t i : among) {
        const ShadowCaster& caster = casters_.casters[i];
        const double bottom = caster.bottomM, top = caster.topM;
        const glm::dvec2 west = caster.low + glm::min(throws.low * bottom, throws.low * top);
        const glm::dvec2 east = caster.high + glm::max(throws.high * bottom, throws.high * top);
        if (where_.any(west, east, band_)) inReach.push_back(i);
    }
}

void StepFiller::fill(std::size_t first, std::span<std::uint64_t> rasters) {
    const StepThrows throws = throwsOf(first, first + stepsTogether);
    reach(throws, everInReach_, inReach_);
    for (std::size_t word = 0; word < noReceivers_.size(); ++word)
        std::fill_n(&rasters[word * stepsTogether], stepsTogether, noReceivers_[word]);
    for (const std::uint32_t index : inReach_)
        count_.rows += std::uint64_t(caster_.fill(index, throws, layout_, band_, rasters));
    const std::size_t steps = std::min(stepsTogether, sun_.steps.size() - first);
    count_.outOfReach += (casters_.casters.size() - inReach_.size()) * steps;
}

std::vector<RowBand> bandsOf(const Grid& grid) {
    const int wordColumns = (grid.columns + 63) / 64,
              rows = std::max(leastRows, std::min(wordsABand / wordColumns, grid.rows / bandsAGrid));
    std::vector<RowBand> bands;
    for (int first = 0; first < grid.rows; first += rows)
        bands.push_back({first, std::min(first + rows, grid.rows)});
    return bands;
}

}  // namespace noonmark
