#include "core/measures/place_sums.h"

#include <fmt/format.h>

namespace noonmark {

namespace {

void takeMore(std::optional<MostShadow>& most, CivilDate day, double areaHoursM2) {
    if (areaHoursM2 > (most ? most->areaHoursM2 : 0)) most = MostShadow{day, areaHoursM2};
}

}  // namespace

void AreaHours::add(const DayTimeline& day) {
    ++days;
    sunlitHours += day.sunlitMinutes / 60;
    theoreticalM2h += day.theoreticalM2h();
    baselineM2h += day.baseline.areaHoursM2;
    scenarioM2h += day.scenario.areaHoursM2;
    incrementalM2h += day.incremental.areaHoursM2;
    gainedM2h += day.gained.areaHoursM2;
}

Quarter quarterOf(CivilDate day) {
    const unsigned at = unsigned(day.month()) * 100 + unsigned(day.day());
    if (at < 321 || at >= 1221) return Quarter::fromDecember;
    if (at < 621) return Quarter::fromMarch;
    return at < 921 ? Quarter::fromJune : Quarter::fromSeptember;
}

void PlaceSums::add(const DayTimeline& day) {
    all_.add(day);
    quarters_[std::size_t(quarterOf(day.day))].add(day);
    months_[fmt::format("{:04}-{:02}", int(day.day.year()), unsigned(day.day.month()))].add(day);
    takeMore(mostScenario_, day.day, day.scenario.areaHoursM2);
    takeMore(mostIncremental_, day.day, day.incremental.areaHoursM2);
    if (day.incremental.largestM2 > largestM2_) {
        largestM2_ = day.incremental.largestM2;
        largestAt_ = day.incremental.largestAt;
    }
}

}  // namespace noonmark
