#include "core/measures/statistics.h"

#include <algorithm>
#include <cmath>

#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

class Sums {
public:
    explicit Sums(const ShadowField& field) : field_(field) {}

    void add(std::size_t cell) {
        const float gross = field_.grossMin[cell];
        if (std::isnan(gross)) return;
        const float continuous = field_.continuousMin[cell];
        ++result_.receivers;
        grossSum_ += gross;
        continuousSum_ += continuous;
        result_.maxGrossMin = std::max(result_.maxGrossMin, double(gross));
        result_.maxContinuousMin = std::max(result_.maxContinuousMin, double(continuous));
    }

    [[nodiscard]] ShadowStatistics result() const {
        ShadowStatistics statistics = result_;
        const double count = double(statistics.receivers);
        statistics.receiverAreaM2 = count * field_.grid.cellAreaM2();
        if (statistics.receivers == 0) return statistics;
        statistics.meanGrossMin = grossSum_ / count;
        statistics.meanContinuousMin = continuousSum_ / count;
        if (field_.sunlitMinutesPerDay > 0)
            statistics.shadowAreaM2 = grossSum_ / field_.sunlitMinutesPerDay * field_.grid.cellAreaM2();
        return statistics;
    }

private:
    const ShadowField& field_;
    ShadowStatistics result_;
    double grossSum_ = 0;
    double continuousSum_ = 0;
};

}  // namespace

ShadowStatistics statisticsOf(const ShadowField& field) {
    Sums sums(field);
    for (std::size_t cell = 0; cell < field.grossMin.size(); ++cell) sums.add(cell);
    return sums.result();
}

ShadowStatistics statisticsOf(const ShadowField& field, const Region& region) {
    std::vector<bool> inside(field.grid.size(), false);
    for (const Footprint& polygon : region.polygons)
        forEachRun(polygon, field.grid, [&](int row, int first, int end) {
            for (int column = first; column < end; ++column) inside[field.grid.index(column, row)] = true;
        });
    Sums sums(field);
    for (std::size_t cell = 0; cell < inside.size(); ++cell)
        if (inside[cell]) sums.add(cell);
    return sums.result();
}

}  // namespace noonmark
