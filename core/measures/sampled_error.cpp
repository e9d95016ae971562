#include "core/measures/sampled_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace noonmark {

namespace {

double standardErrorOf(std::span<const double> values, double mean) {
    const auto count = double(values.size());
    if (count < 2) return mean;  // one value says nothing of its spread
    double squares = 0;
    for (const double value : values) squares += std::pow(value - mean, 2);
    return std::sqrt(squares / (count - 1) / count);
}

template <class Difference>
CellError cellErrorOf(std::span<const ComparedCell> cells, double wholeMin, const Difference& difference) {
    CellError error{.wholeMin = wholeMin};
    std::vector<double> off;
    for (const ComparedCell& cell : cells) {
        off.push_back(std::abs(difference(cell)));
        error.meanMin += off.back() / double(cells.size());
        if (off.size() > 1 && off.back() <= error.maxMin) continue;
        error.maxMin = off.back();
        error.worstM = cell.centreM;
    }
    if (off.empty()) return error;
    error.meanStandardErrorMin = standardErrorOf(off, error.meanMin);
    const auto rank = std::size_t(std::ceil(0.99 * double(off.size()))) - 1;  // nearest rank
    std::ranges::nth_element(off, off.begin() + std::ptrdiff_t(rank));
    error.p99Min = off[rank];
    return error;
}

double grossDifference(const ComparedCell& cell) { return cell.grossMin - cell.referenceGrossMin; }

double continuousDifference(const ComparedCell& cell) {
    return cell.continuousMin - cell.referenceContinuousMin;
}

CellError continuousErrorOf(std::span<const ComparedCell> cells, double longestDayMin) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    if (std::ranges::any_of(cells, [](const ComparedCell& cell) { return std::isnan(cell.continuousMin); }))
        return {.meanMin = unknown, .p99Min = unknown, .maxMin = unknown, .wholeMin = longestDayMin};
    return cellErrorOf(cells, longestDayMin, continuousDifference);
}

// Cells are of equal size: the error of the area is the mean of the cells' errors.
void addArea(SampledError& error, std::span<const ComparedCell> cells) {
    const auto count = double(cells.size());
    double mean = 0;
    std::vector<double> off;
    for (const ComparedCell& cell : cells) off.push_back(grossDifference(cell));
    for (const double difference : off) mean += difference / count;
    error.areaPct = error.gross.percent(mean);
    if (cells.size() > 1) error.areaStandardErrorPct = error.gross.percent(standardErrorOf(off, mean));
}

}  // namespace

SampledError errorOf(std::span<const ComparedCell> cells, double sunlitMinutesPerDay, double longestDayMin) {
    SampledError error{.receivers = cells.size()};
    error.gross = cellErrorOf(cells, sunlitMinutesPerDay, grossDifference);
    error.continuous = continuousErrorOf(cells, longestDayMin);
    addArea(error, cells);
    return error;
}

}  // namespace noonmark
