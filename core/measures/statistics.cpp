#include "core/measures/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/engines/api/blank_field.h"
#include "core/measures/has_runs.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

void addCell(ShadowSums& sums, const ShadowField& field, std::size_t cell) {
    const float gross = field.grossMin[cell];
    if (std::isnan(gross)) return;
    const float continuous = field.continuousMin[cell];
    sums.add({1, gross, continuous, gross, continuous});
}

}  // namespace

void ShadowSums::add(const ShadowSums& piece) {
    receivers += piece.receivers;
    grossMin += piece.grossMin;
    continuousMin += piece.continuousMin;
    maxGrossMin = std::max(maxGrossMin, piece.maxGrossMin);
    maxContinuousMin = std::max(maxContinuousMin, piece.maxContinuousMin);
}

ShadowSums computeSums(const ShadowField& field) {
    ShadowSums sums;
    for (std::size_t cell = 0; cell < field.grossMin.size(); ++cell) addCell(sums, field, cell);
    return sums;
}

ShadowStatistics computeStatistics(const ShadowSums& sums, double sunlitMinutesPerDay, double cellAreaM2) {
    if (sums.receivers == 0) return {};
    const auto count = double(sums.receivers);
    ShadowStatistics statistics{.receivers = sums.receivers, .receiverAreaM2 = count * cellAreaM2};
    statistics.meanGrossMin = sums.grossMin / count;
    statistics.meanSunMin = std::max(sunlitMinutesPerDay - statistics.meanGrossMin, 0.0);
    statistics.meanContinuousMin = sums.continuousMin / count;
    statistics.maxGrossMin = sums.maxGrossMin;
    statistics.maxContinuousMin =
        hasRuns(statistics) ? sums.maxContinuousMin : std::numeric_limits<double>::quiet_NaN();
    if (sunlitMinutesPerDay > 0) statistics.shadowAreaM2 = sums.grossMin / sunlitMinutesPerDay * cellAreaM2;
    return statistics;
}

ShadowStatistics computeStatistics(const ShadowField& field) {
    ShadowStatistics statistics =
        computeStatistics(computeSums(field), field.sunlitMinutesPerDay, field.grid.cellAreaM2());
    statistics.waterM2 = findWaterM2(field);
    return statistics;
}

ShadowStatistics computeStatistics(const ShadowField& field, const Region& region) {
    ShadowSums sums;
    for (const std::uint32_t cell : collectCells(region.polygons, field.grid)) addCell(sums, field, cell);
    return computeStatistics(sums, field.sunlitMinutesPerDay, field.grid.cellAreaM2());
}

}  // namespace noonmark
