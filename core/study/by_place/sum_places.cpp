#include "core/study/by_place/sum_places.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/city/footprints/plan_overlay.h"
#include "core/engines/api/shadow_field.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

constexpr double besideM = 2;  // as far apart as a path between a lawn and its park

bool isGround(const Place& place) {
    return place.kind != PlaceKind::street && place.kind != PlaceKind::facade &&
           place.kind != PlaceKind::stainedGlass;
}

/// How much of a part belongs to a whole: above 1 where it holds more than half, else the share of its
/// outline along it.
double weigh(const Place& part, const Place& whole) {
    const double held = computeSharedArea(part.polygons, whole.polygons) / area(part);
    if (held > 0.5) return 1 + held;
    const double along = computeShareBeside(part.polygons, whole.polygons, besideM);
    return along > 0.2 ? along : 0;
}

}  // namespace

std::vector<std::optional<std::size_t>> findWholes(const std::vector<Place>& places,
                                                   const std::stop_token& stop) {
    std::vector<std::size_t> parts, wholes;
    std::vector<Box2> wide, boxes;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!isGround(places[i])) continue;
        const Box2 box = bounds(places[i]);
        const glm::vec2 margin{float(besideM)};
        const bool isNamed = hasOwnName(places[i]);
        (isNamed ? wholes : parts).push_back(i);
        (isNamed ? boxes : wide).push_back(isNamed ? box : Box2{box.low - margin, box.high + margin});
    }
    std::vector<std::optional<std::size_t>> found(places.size());
    std::vector<double> maximum(places.size(), 0);
    for (const auto& [a, b] : findMeetingBoxes(wide, boxes)) {
        if (stop.stop_requested()) break;
        const std::size_t part = parts[a], whole = wholes[b];
        const double weight = weigh(places[part], places[whole]);
        if (weight <= maximum[part]) continue;
        maximum[part] = weight;
        found[part] = whole;
    }
    return found;
}

namespace {

double hoursAt(const MeanDay& day, const CountedCell& one) {
    return std::max(0.0, day.sunlitMin - double(day.grossMin[one.receiver])) / 60;
}

/// Shares of the area of a place, from hours a day at its cells.
struct AreaSums {
    double cells = 0, hours = 0, enough = 0;
};

template <class Hours>
AreaSums sumUp(const std::vector<CountedCell>& cells, double enoughHours, Hours&& hours) {
    AreaSums sums;
    for (const CountedCell& one : cells) {
        const double at = hours(one);
        sums.cells += one.share;
        sums.hours += one.share * at;
        if (float(at) >= float(enoughHours)) sums.enough += one.share;  // as computeEnoughShare() compares
    }
    return sums;
}

SunOfPlace summarize(const Grid& grid, const MeanDay& day, const std::vector<CountedCell>& cells,
                     double enoughHours) {
    SunOfPlace sun;
    if (cells.empty()) return sun;
    const auto hours = [&](const CountedCell& one) { return hoursAt(day, one); };
    const AreaSums sums = sumUp(cells, enoughHours, hours);
    sun.cellM = grid.cellM;
    sun.areaM2 = sums.cells * grid.cellAreaM2();
    sun.meanHours = sums.hours / sums.cells;
    sun.enoughShare = sums.enough / sums.cells;
    for (const CountedCell& one : cells)
        sun.ofCells.push_back({float(hours(one)), float(one.share), one.isInside});
    const bool anyInside = std::ranges::any_of(cells, &CountedCell::isInside);
    for (const CountedCell& one : cells) {
        if (anyInside && !one.isInside) continue;
        ++sun.cells;
        sun.minHours = std::fmin(sun.minHours, hours(one));
        sun.maxHours = std::fmax(sun.maxHours, hours(one));
    }
    return sun;
}

std::vector<double> averageMonths(const ShadowBreakdown& sums, const std::vector<double>& days,
                                  const std::vector<CountedCell>& cells) {
    std::vector<double> means;
    for (std::size_t month = 0; month < days.size(); ++month) {
        const AreaSums all = sumUp(cells, 0, [&](const CountedCell& one) {
            return (sums.sunlitMinutes[month] - double(sums.minutes[month][one.receiver])) / 60 / days[month];
        });
        means.push_back(all.hours / all.cells);
    }
    return means;
}

// Index in the year of a month's three months, December to February first.
constexpr std::array seasonKeys{"dec_feb", "mar_may", "jun_aug", "sep_nov"};

std::size_t quarterOf(const std::string& month) {
    const int number = std::stoi(month.substr(month.size() - 2));
    return std::size_t(number % 12) / 3;
}

// Means of the months, each by its days.
std::vector<double> averageSeasons(const std::vector<std::string>& months, const std::vector<double>& days,
                                   const std::vector<double>& hours) {
    std::array<double, 4> sums{}, counts{};
    for (std::size_t month = 0; month < months.size(); ++month) {
        sums[quarterOf(months[month])] += hours[month] * days[month];
        counts[quarterOf(months[month])] += days[month];
    }
    std::vector<double> means;
    for (std::size_t quarter = 0; quarter < sums.size(); ++quarter)
        if (counts[quarter] > 0) means.push_back(sums[quarter] / counts[quarter]);
    return means;
}

}  // namespace

std::vector<SunSeason> listSeasons(const std::vector<std::string>& months, double latDeg) {
    constexpr double tropicDeg = 23.44;
    constexpr std::array labels{"Dec to Feb", "Mar to May", "Jun to Aug", "Sep to Nov"};
    constexpr std::array names{"winter", "spring", "summer", "autumn"};
    std::vector<SunSeason> seasons;
    for (std::size_t quarter = 0; quarter < seasonKeys.size(); ++quarter) {
        const auto isIn = [&](const std::string& month) { return quarterOf(month) == quarter; };
        if (std::ranges::none_of(months, isIn)) continue;
        const std::string season = names[(quarter + (latDeg < 0 ? 2 : 0)) % names.size()];
        const bool isTropical = std::abs(latDeg) < tropicDeg;
        seasons.push_back({seasonKeys[quarter],
                           isTropical ? labels[quarter] : fmt::format("{} ({})", labels[quarter], season)});
    }
    return seasons;
}

bool isIn(const SunSeason& season, const std::string& month) {
    return season.key == seasonKeys[quarterOf(month)];
}

std::vector<double> countDays(const SunSteps& sun) {
    std::vector<double> days;
    std::chrono::year_month last{};
    for (const SunDay& day : sun.days) {
        const std::chrono::year_month month{day.date.year(), day.date.month()};
        if (month != std::exchange(last, month)) days.push_back(0);
        ++days.back();
    }
    return days;
}

MeanDay averageDay(const ShadowBreakdown& sums, const SunSteps& sun) {
    MeanDay day{.grossMin = std::vector<float>(sums.cells.size()),
                .sunlitMin = sun.sunlitMinutes() / double(sun.dayCount())};
    for (std::size_t i = 0; i < day.grossMin.size(); ++i) {
        double minutes = 0;
        for (const auto& ofSet : sums.minutes) minutes += double(ofSet[i]);
        day.grossMin[i] = float(minutes / double(sun.dayCount()));
    }
    return day;
}

ShadowField makeField(const ShadowBreakdown& sums, const MeanDay& day, const Receivers& receivers,
                      const SunSteps& sun) {
    ShadowField field = makeBlankField(receivers, sun);
    std::ranges::fill(field.continuousMin, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < day.grossMin.size(); ++i)
        field.grossMin[receivers.cells[i]] = day.grossMin[i];
    field.engine = sums.engine;
    return field;
}

void takeMonths(const SunByPlace& made, const CellGroup& group, const ShadowBreakdown& sums,
                const MeanDay& day, std::vector<SunOfPlace>& sun) {
    const std::vector<double> days = countDays(made.daylight);
    for (std::size_t i = 0; i < group.places.size(); ++i) {
        SunOfPlace& own = sun[group.places[i]];
        own = summarize(sums.grid, day, group.cells[i], made.settings.enoughHours);
        own.monthHours = averageMonths(sums, days, group.cells[i]);
        own.seasonHours = averageSeasons(made.months, days, own.monthHours);
    }
}

void takeDate(const SunByPlace& made, const CellGroup& group, const MeanDay& day,
              std::vector<SunOfPlace>& sun) {
    for (std::size_t i = 0; i < group.places.size(); ++i) {
        const AreaSums sums = sumUp(group.cells[i], made.settings.enoughHours,
                                    [&](const CountedCell& one) { return hoursAt(day, one); });
        SunOfPlace& own = sun[group.places[i]];
        std::vector<float>& ofCells = own.dateHoursOfCells.emplace_back();
        for (const CountedCell& one : group.cells[i]) ofCells.push_back(float(hoursAt(day, one)));
        own.dateHours.push_back(sums.hours / sums.cells);
        own.belowShare.push_back(1 - sums.enough / sums.cells);
    }
}

}  // namespace noonmark
