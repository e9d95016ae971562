#include "core/study/point_losses.h"

#include <algorithm>

namespace noonmark {

namespace {

constexpr std::size_t widestGapDays = 3;

struct DayLoss {
    std::vector<int> clockMinutes;  // of the steps taken
};

std::vector<DayLoss> lossesByDay(const ShadedSteps& before, const ShadedSteps& after, const SunSteps& sun,
                                 const Zone& zone) {
    std::vector<DayLoss> losses(sun.days.size());
    for (std::size_t day = 0; day < losses.size(); ++day)
        for (std::uint32_t i = sun.days[day].first; i < sun.days[day].first + sun.days[day].count; ++i) {
            if (before[i] != 0 || after[i] == 0) continue;
            const auto at = std::chrono::floor<std::chrono::seconds>(sun.steps[i].at);
            const auto clock = (at + zone.offsetAt(at)).time_since_epoch() % std::chrono::days(1);
            losses[day].clockMinutes.push_back(int(std::chrono::floor<std::chrono::minutes>(clock).count()));
        }
    return losses;
}

SeasonOfLoss seasonOf(const std::vector<DayLoss>& losses, std::size_t first, std::size_t last,
                      const SunSteps& sun) {
    std::vector<int> clock;
    SeasonOfLoss season{.first = sun.days[first].date, .last = sun.days[last].date};
    for (std::size_t day = first;; day = (day + 1) % losses.size()) {
        const auto& minutes = losses[day].clockMinutes;
        clock.insert(clock.end(), minutes.begin(), minutes.end());
        season.days += minutes.empty() ? 0 : 1;
        if (day == last) break;
    }
    std::ranges::sort(clock);
    season.minutesPerDay = double(clock.size()) * sun.stepMinutes / season.days;
    season.mostlyFrom = std::chrono::minutes(clock[clock.size() / 10]);
    season.mostlyTo = std::chrono::minutes(clock[clock.size() - 1 - clock.size() / 10] + 1);
    return season;
}

// A day with losses after more than the widest gap without.
bool beginsSeason(const std::vector<DayLoss>& losses, std::size_t day) {
    if (losses[day].clockMinutes.empty()) return false;
    for (std::size_t back = 1; back <= std::min(widestGapDays + 1, losses.size() - 1); ++back)
        if (!losses[(day + losses.size() - back) % losses.size()].clockMinutes.empty()) return false;
    return true;
}

std::size_t endOfSeason(const std::vector<DayLoss>& losses, std::size_t first) {
    std::size_t last = first;
    for (std::size_t day = first + 1; day < first + losses.size() && day - last <= widestGapDays + 1; ++day)
        if (!losses[day % losses.size()].clockMinutes.empty()) last = day;
    return last % losses.size();
}

}  // namespace

std::vector<SeasonOfLoss> findLosses(const ShadedSteps& before, const ShadedSteps& after, const SunSteps& sun,
                                     const Zone& zone) {
    const std::vector<DayLoss> losses = lossesByDay(before, after, sun, zone);
    const bool any =
        std::ranges::any_of(losses, [](const DayLoss& day) { return !day.clockMinutes.empty(); });
    std::vector<SeasonOfLoss> seasons;
    for (std::size_t day = 0; day < losses.size(); ++day)
        if (beginsSeason(losses, day))
            seasons.push_back(seasonOf(losses, day, endOfSeason(losses, day), sun));
    if (any && seasons.empty()) seasons.push_back(seasonOf(losses, 0, losses.size() - 1, sun));
    std::ranges::sort(seasons, std::ranges::greater(),
                      [](const SeasonOfLoss& season) { return season.minutesPerDay * season.days; });
    return seasons;
}

}  // namespace noonmark
