#include "core/study/tiles/month_sums.h"

#include <algorithm>

namespace noonmark {

void MonthSums::add(const TileResult& tile) {
    receivers_ += tile.sums.receivers;
    minutes_.resize(std::max(minutes_.size(), tile.monthMinutes.size()));
    for (std::size_t i = 0; i < tile.monthMinutes.size(); ++i) minutes_[i] += tile.monthMinutes[i];
}

std::vector<MonthShadow> MonthSums::months(const StudySettings& settings, const SunSteps& sun,
                                           double cellAreaM2) const {
    if (!settings.byMonth) return {};
    const StepSets sets = monthsOf(sun);
    std::vector<double> minutes = minutes_;
    minutes.resize(sets.names.size());
    return monthsFromSums(sets, sets.sunlitMinutes(sun), minutes, receivers_, cellAreaM2);
}

}  // namespace noonmark
