#include "core/engines/projected/filling/step_filler.h"

#include <algorithm>
#include <numeric>

#include "core/engines/projected/casters/shadow_offsets.h"

namespace noonmark {

namespace {

constexpr int wordsABand = 1536, minRows = 64, bandsAGrid = 8;

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
    if (!sun.steps.empty()) reach(computeOffsets(sun, cellM_, 0, sun.steps.size()), all, everInReach_);
}

void StepFiller::reach(const StepOffsets& throws, const Indices& among, Indices& inReach) const {
    inReach.clear();
    for (const std::uint32_t i : among) {
        const SweptBox box = computeSweptBox(casters_.casters[i], throws);
        if (where_.any(box.low, box.high, band_)) inReach.push_back(i);
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

std::vector<RowBand> bandsOf(const Grid& grid) {
    const int wordColumns = (grid.columns + 63) / 64,
              rows = std::max(minRows, std::min(wordsABand / wordColumns, grid.rows / bandsAGrid));
    std::vector<RowBand> bands;
    for (int first = 0; first < grid.rows; first += rows)
        bands.push_back({first, std::min(first + rows, grid.rows)});
    return bands;
}

}  // namespace noonmark
