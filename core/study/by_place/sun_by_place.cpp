#include "core/study/by_place/sun_by_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/base/memory_guard.h"
#include "core/base/progress_share.h"
#include "core/base/stopwatch.h"
#include "core/city/map_context.h"
#include "core/city/terrain/post_grid.h"
#include "core/describe/text.h"
#include "core/engines/api/blank_field.h"
#include "core/measures/place_cells.h"
#include "core/measures/place_receivers.h"
#include "core/measures/take_error.h"
#include "core/receivers/place_names.h"
#include "core/study/by_place/city_sweeps.h"
#include "core/study/by_place/place_parts.h"
#include "core/study/memory_need.h"
#include "core/study/terrain_coverage.h"
#include "core/sun/zone_question.h"

namespace noonmark {

namespace {

/// A cell of a place: its index in the grid, and how much of it counts.
struct CountedCell {
    std::uint32_t cell = 0;
    double share = 1;
    bool isInside = true;  ///< its centre lies in the place
};

std::vector<CountedCell> listCells(const PlaceReceivers& on, std::size_t place) {
    std::vector<CountedCell> cells;
    auto uneven = on.unevenOf[place].begin();
    for (const CellSpan& span : on.cellsOf[place])
        for (std::uint32_t i = 0; i < span.count; ++i) {
            CountedCell one{on.receivers.cells[span.first + i]};
            if (uneven != on.unevenOf[place].end() && uneven->bit == cells.size()) {
                one.share += uneven->extra;
                one.isInside = !uneven->isBeside;
                ++uneven;
            }
            cells.push_back(one);
        }
    return cells;
}

/// Places that share a grid.
struct CellGroup {
    std::vector<std::size_t> places;  ///< indices
    PlaceReceivers on;
    std::vector<std::vector<CountedCell>> cells;  ///< of each of them
};

/// An engine that the one asked for chose; null: it chooses none, or one that sums no months.
struct ChosenEngine {
    std::string key;
    std::unique_ptr<Engine> engine;
};

/// What is measured, in the course of it.
struct Measuring {
    std::vector<const City*> cities;  ///< the first is the baseline
    const Engine& engine;
    std::vector<SunByPlace>& made;  ///< of each city
    Progress& progress;
    std::stop_token stop;
    SunSteps daylight{};
    StepSets months{};
    std::vector<SunSteps> dates{};
    std::function<void(double)> takeForecast{};  ///< empty: nobody asks
    Stopwatch watch{};
    /// For the cells of all places, over the period and on each date. Small places are measured by the same,
    /// so that the error of the others is theirs, too.
    std::vector<ChosenEngine> chosen{};
    std::vector<SampledOff> off{};  ///< samples after which the engine was changed for a closer one

    [[nodiscard]] const SunByPlaceSettings& settings() const { return made.front().settings; }
    [[nodiscard]] const std::vector<Place>& places() const { return made.front().places; }
    Warnings& warnings() { return made.front().warnings; }
};

template <class Stage>
Result<void> timeStage(SunByPlace& made, const char* name, Stage&& stage) {
    const Stopwatch watch;
    auto done = std::forward<Stage>(stage)();
    made.seconds[name] += watch.seconds();
    return done;
}

Result<void> checkSettings(const SunByPlaceSettings& settings, const std::vector<Place>& places) {
    if (places.empty())
        return failure("There is no place to measure", "places",
                       "Choose other kinds of places, or read a file of places");
    if (!(settings.enoughHours >= 0 && settings.enoughHours <= SunByPlaceSettings::maxHours))
        return failure("The hours of sun that are enough must be 0 to 24",
                       fmt::format("{:g} h", settings.enoughHours), "Give hours a day");
    if (!(settings.lossMin >= 0 && settings.lossMin <= SunByPlaceSettings::maxLossMin))
        return failure("The minutes of sun that may be lost must be 0 to 1440",
                       fmt::format("{:g} min", settings.lossMin), "Give minutes a day");
    if (settings.dates.size() > SunByPlaceSettings::maxDates)
        return failure("There are too many dates", fmt::format("{} dates", settings.dates.size()),
                       fmt::format("Give at most {}", SunByPlaceSettings::maxDates));
    const double smallM = settings.smallCellM;
    if (!(smallM >= ReceiverSettings::minCellM && smallM <= ReceiverSettings::maxCellM))
        return failure(fmt::format("The cells of small places must be {:g} to {:g} m",
                                   ReceiverSettings::minCellM, ReceiverSettings::maxCellM),
                       fmt::format("{:g} m", smallM), "Give metres");
    return validate(settings.study.period).map([](const auto&) {});
}

Region unite(const std::vector<Place>& places) {
    Region region{.name = "places", .polygons = {}};
    for (const Place& place : places)
        region.polygons.insert(region.polygons.end(), place.polygons.begin(), place.polygons.end());
    return region;
}

Result<CellGroup> placeGroup(const Measuring& m, std::vector<std::size_t> which, double cellM) {
    std::vector<Place> places;
    for (const std::size_t i : which) places.push_back(m.places()[i]);
    auto on = placeReceiversOnPlaces(m.cities, places, {.cellM = cellM}, m.stop);
    if (!on) return tl::make_unexpected(on.error());
    CellGroup group{std::move(which), *std::move(on), {}};
    for (std::size_t i = 0; i < places.size(); ++i) group.cells.push_back(listCells(group.on, i));
    return group;
}

Result<CellGroup> placeAll(const Measuring& m) {
    std::vector<std::size_t> all(m.places().size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    auto group = placeGroup(m, std::move(all), m.settings().study.receivers.cellM);
    if (group && group->on.receivers.cells.empty())
        return failure("No cell of the places lies on open ground", "places", "Choose smaller cells");
    return group;
}

double countCells(const std::vector<CountedCell>& cells) {
    double sum = 0;
    for (const CountedCell& one : cells) sum += one.share;
    return sum;
}

// Small places, those in one square together: a fine grid over a whole city would be too large, and each
// square takes its own walls of buildings.
std::map<std::pair<int, int>, std::vector<std::size_t>> listSmall(const Measuring& m, const CellGroup& all) {
    constexpr double cellsOfSide = 3000;
    const auto squareM = float(cellsOfSide * m.settings().smallCellM);
    std::map<std::pair<int, int>, std::vector<std::size_t>> small;
    if (m.settings().smallCellM >= m.settings().study.receivers.cellM) return small;
    for (std::size_t i = 0; i < m.places().size(); ++i) {
        if (countCells(all.cells[i]) >= SunByPlaceSettings::smallPlaceCells) continue;
        const Box2 box = bounds(m.places()[i]);
        const glm::vec2 square = glm::floor((box.low + box.high) / 2.0F / squareM);
        small[{int(square.x), int(square.y)}].push_back(i);
    }
    return small;
}

// They keep what the larger cells find of them.
void leaveOutPlacesWithoutCells(CellGroup& group) {
    for (std::size_t i = group.places.size(); i-- > 0;) {
        if (!group.cells[i].empty()) continue;
        group.places.erase(group.places.begin() + std::ptrdiff_t(i));
        group.cells.erase(group.cells.begin() + std::ptrdiff_t(i));
    }
}

Result<std::vector<CellGroup>> placeSmall(const Measuring& m, const CellGroup& all) {
    std::vector<CellGroup> groups;
    for (auto& [square, which] : listSmall(m, all)) {
        auto group = placeGroup(m, std::move(which), m.settings().smallCellM);
        if (!group) return tl::make_unexpected(group.error());
        leaveOutPlacesWithoutCells(*group);
        if (!group->places.empty()) groups.push_back(*std::move(group));
    }
    return groups;
}

Result<void> findSun(Measuring& m, const Receivers& receivers) {
    const City& city = *m.cities.front();
    const StudySettings& study = m.settings().study;
    const Observer observer = makeObserver(city, study);
    auto sun = computeDaylightSteps(study.period, observer, m.stop);
    if (!sun) return tl::make_unexpected(sun.error());
    m.daylight = *std::move(sun);
    m.months = monthsOf(m.daylight);
    for (const CivilDate& date : m.settings().dates) {
        Period day = study.period;
        day.start = date;
        day.days = 1;
        auto ofDay = computeSunSteps(day, observer, m.stop);
        if (!ofDay) return tl::make_unexpected(ofDay.error());
        m.dates.push_back(*std::move(ofDay));
    }
    const TerrainCoverage coverage = computeTerrainCoverage(city, receivers, m.daylight);
    for (Warning& warning : makeWarnings(coverage)) m.warnings().push_back(std::move(warning));
    const Box2 box = bounds(study.region);
    const LonLat middle = city.frame.lonLatFromLocal(glm::dvec2(box.low + box.high) / 2.0);
    if (auto question = questionZone(study.period, middle)) m.warnings().push_back(*std::move(question));
    return checkCoverage(coverage, study.region.name);
}

// A failure to measure the error does not fail the study; only a stop request ends it.
Result<std::optional<SampledError>> measureError(Measuring& m, std::size_t city, const Receivers& receivers,
                                                 const SunSteps& sun, const ShadowField& field) {
    std::optional<SampledError> error;
    const ErrorSampleSettings& sample = m.settings().study.errorSample;
    if (sample.receivers == 0 || m.settings().study.engine == referenceEngine) return error;
    NoProgress quiet;
    auto taken = takeError(sampleError(*m.cities[city], receivers, sun, field, sample, quiet, m.stop), error,
                           m.made[city].warnings);
    if (!taken) return tl::make_unexpected(taken.error());
    return error;
}

double hoursAt(const ShadowField& field, std::uint32_t cell) {
    return std::max(0.0, field.sunlitMinutesPerDay - double(field.grossMin[cell])) / 60;
}

/// Shares of the area of a place, from hours a day at its cells.
struct AreaSums {
    double cells = 0, hours = 0, enough = 0;
};

template <class Hours>
AreaSums sumUp(const std::vector<CountedCell>& cells, double enoughHours, Hours&& hours) {
    AreaSums sums;
    for (const CountedCell& one : cells) {
        const double at = hours(one.cell);
        sums.cells += one.share;
        sums.hours += one.share * at;
        if (at >= enoughHours) sums.enough += one.share;
    }
    return sums;
}

// The days of each month, with those on which the sun does not rise.
std::vector<double> countDays(const SunSteps& sun, const std::vector<std::string>& months) {
    std::vector<double> days(months.size());
    for (const SunDay& day : sun.days) {
        const std::string name = fmt::format("{:04}-{:02}", int(day.date.year()), unsigned(day.date.month()));
        const auto found = std::ranges::find(months, name);
        if (found != months.end()) ++days[std::size_t(found - months.begin())];
    }
    return days;
}

SunOfPlace summarize(const ShadowField& field, const std::vector<CountedCell>& cells, double enoughHours) {
    SunOfPlace sun;
    if (cells.empty()) return sun;
    const auto hours = [&](std::uint32_t cell) { return hoursAt(field, cell); };
    const AreaSums sums = sumUp(cells, enoughHours, hours);
    sun.cellM = field.grid.cellM;
    sun.areaM2 = sums.cells * field.grid.cellAreaM2();
    sun.meanHours = sums.hours / sums.cells;
    sun.enoughShare = sums.enough / sums.cells;
    for (const CountedCell& one : cells)
        sun.ofCells.push_back({float(hours(one.cell)), float(one.share), one.isInside});
    const bool anyInside = std::ranges::any_of(cells, &CountedCell::isInside);
    for (const CountedCell& one : cells) {
        if (anyInside && !one.isInside) continue;
        ++sun.cells;
        sun.minHours = std::fmin(sun.minHours, hours(one.cell));
        sun.maxHours = std::fmax(sun.maxHours, hours(one.cell));
    }
    return sun;
}

std::vector<double> averageMonths(const ShadowBreakdown& sums, const std::vector<double>& days,
                                  const std::vector<CountedCell>& cells) {
    std::vector<double> means;
    for (std::size_t month = 0; month < days.size(); ++month) {
        const AreaSums all = sumUp(cells, 0, [&](std::uint32_t cell) {
            return (sums.sunlitMinutes[month] - double(sums.minutes[month][cell])) / 60 / days[month];
        });
        means.push_back(all.hours / all.cells);
    }
    return means;
}

// Index in the year of a month's three months, December to February first.
std::size_t quarterOf(const std::string& month) {
    const int number = std::stoi(month.substr(month.size() - 2));
    return std::size_t(number % 12) / 3;
}

std::vector<SunSeason> listSeasons(const std::vector<std::string>& months, double latDeg) {
    constexpr double tropicDeg = 23.44;
    constexpr std::array keys{"dec_feb", "mar_may", "jun_aug", "sep_nov"};
    constexpr std::array labels{"Dec to Feb", "Mar to May", "Jun to Aug", "Sep to Nov"};
    constexpr std::array names{"winter", "spring", "summer", "autumn"};
    std::vector<SunSeason> seasons;
    for (std::size_t quarter = 0; quarter < keys.size(); ++quarter) {
        const auto isIn = [&](const std::string& month) { return quarterOf(month) == quarter; };
        if (std::ranges::none_of(months, isIn)) continue;
        const std::string season = names[(quarter + (latDeg < 0 ? 2 : 0)) % names.size()];
        const bool isTropical = std::abs(latDeg) < tropicDeg;
        seasons.push_back(
            {keys[quarter], isTropical ? labels[quarter] : fmt::format("{} ({})", labels[quarter], season)});
    }
    return seasons;
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

// Of a place without a cell: NaN, as many as of the others.
void takeMonths(SunByPlace& made, const CellGroup& group, const ShadowBreakdown& sums,
                const ShadowField& field, const std::vector<double>& days) {
    for (std::size_t i = 0; i < group.places.size(); ++i) {
        SunOfPlace& sun = made.sun[group.places[i]];
        sun = summarize(field, group.cells[i], made.settings.enoughHours);
        sun.monthHours = averageMonths(sums, days, group.cells[i]);
        sun.seasonHours = averageSeasons(made.months, days, sun.monthHours);
    }
}

void takeDate(SunByPlace& made, const CellGroup& group, const ShadowField& field) {
    for (std::size_t i = 0; i < group.places.size(); ++i) {
        const AreaSums sums = sumUp(group.cells[i], made.settings.enoughHours,
                                    [&](std::uint32_t cell) { return hoursAt(field, cell); });
        SunOfPlace& sun = made.sun[group.places[i]];
        sun.dateHours.push_back(sums.hours / sums.cells);
        sun.belowShare.push_back(1 - sums.enough / sums.cells);
    }
}

/// Measures the places of one group in all cities.
class GroupMeasure {
public:
    GroupMeasure(Measuring& m, const CellGroup& group, bool isMain, Progress& progress)
        : m_(m), group_(group), receivers_(group.on.receivers), isMain_(isMain), progress_(progress) {}

    Result<void> run() {
        if (auto done = timeStage(m_.made.front(), "accumulate", [&] { return sweepMonths(); }); !done)
            return done;
        for (std::size_t date = 0; date < m_.dates.size(); ++date)
            if (auto done = timeStage(m_.made.front(), "dates", [&] { return sweepDate(date); }); !done)
                return done;
        return {};
    }

    /// Seconds that run() is expected to take, if no sample is off.
    [[nodiscard]] double forecast() const {
        const StudySettings& study = m_.settings().study;
        const std::size_t sample = isMain_ ? std::size_t(study.errorSample.receivers) : 0;
        double seconds =
            CitySweeps(engineOf(0), m_.cities, receivers_, m_.daylight, m_.months).forecast(keyOf(0), sample);
        for (std::size_t date = 0; date < m_.dates.size(); ++date) {
            const SunSteps& day = m_.dates[date];
            if (day.steps.empty() || m_.stop.stop_requested()) continue;
            const StepSets one = makeOneSet(day);
            seconds += CitySweeps(engineOf(date + 1), m_.cities, receivers_, day, one)
                           .forecast(keyOf(date + 1), sample);
        }
        return seconds;
    }

private:
    // Over the period (0) or on a date (1 and on).
    [[nodiscard]] const Engine& engineOf(std::size_t sweep) const {
        const auto& own = m_.chosen[sweep].engine;
        return isMain_ || !own ? m_.engine : *own;
    }
    [[nodiscard]] std::string_view keyOf(std::size_t sweep) const {
        const ChosenEngine& own = m_.chosen[sweep];
        return isMain_ || !own.engine ? std::string_view(m_.settings().study.engine)
                                      : std::string_view(own.key);
    }

    // By the engine in use, and by those that it goes on to while samples are off by more than it aims at.
    Result<void> sweepMonths() {
        CitySweeps sweeps(m_.off.empty() ? engineOf(0) : m_.engine, m_.cities, receivers_, m_.daylight,
                          m_.months);
        for (const SampledOff& off : m_.off) sweeps.goOn(off);
        for (;;) {
            auto first = sweepFirst(sweeps);
            if (!first) return tl::make_unexpected(first.error());
            const auto& error = m_.made.front().error;
            if (isMain_ && error && sweeps.goOn(error->grossOff())) {
                m_.off.push_back(error->grossOff());
                continue;
            }
            return sweepOthers(sweeps, *first);
        }
    }

    Result<ShadowBreakdown> sweepFirst(CitySweeps& sweeps) {
        ProgressShare share = nextShare();
        auto sums = sweeps.sweepFirst(share, m_.stop);
        if (!sums) return sums;
        if (auto taken = take(0, *sums); !taken) return tl::make_unexpected(taken.error());
        return sums;
    }

    Result<void> sweepOthers(CitySweeps& sweeps, const ShadowBreakdown& first) {
        for (std::size_t city = 1; city < m_.cities.size(); ++city) {
            ProgressShare share = nextShare();
            const auto sums = sweeps.sweepOther(city, first, share, m_.stop);
            if (!sums) return tl::make_unexpected(sums.error());
            if (auto taken = take(city, *sums); !taken) return taken;
        }
        return {};
    }

    Result<void> take(std::size_t city, const ShadowBreakdown& sums) {
        SunByPlace& made = m_.made[city];
        ShadowField field = makeField(sums, receivers_, m_.daylight);
        takeMonths(made, group_, sums, field, countDays(m_.daylight, made.months));
        if (!isMain_) return {};
        const Stopwatch watch;
        auto error = measureError(m_, city, receivers_, m_.daylight, field);
        made.seconds["error_sample"] += watch.seconds();
        if (!error) return tl::make_unexpected(error.error());
        made.error = *error;
        made.field = std::move(field);
        return {};
    }

    // A day on which the sun does not rise leaves every cell without sun.
    Result<void> sweepDate(std::size_t date) {
        const SunSteps& sun = m_.dates[date];
        const StepSets one = makeOneSet(sun);
        if (sun.steps.empty()) {
            for (std::size_t city = 0; city < m_.cities.size(); ++city)
                if (auto taken = takeDay(city, sun, makeBlankField(receivers_, sun)); !taken) return taken;
            return {};
        }
        CitySweeps sweeps(engineOf(date + 1), m_.cities, receivers_, sun, one);
        std::optional<ShadowBreakdown> first;
        for (std::size_t city = 0; city < m_.cities.size(); ++city) {
            ProgressShare share = nextShare();
            auto sums = city == 0 ? sweeps.sweepFirst(share, m_.stop)
                                  : sweeps.sweepOther(city, *first, share, m_.stop);
            if (!sums) return tl::make_unexpected(sums.error());
            if (auto taken = takeDay(city, sun, makeField(*sums, receivers_, sun)); !taken) return taken;
            if (city == 0) first = *std::move(sums);
        }
        return {};
    }

    Result<void> takeDay(std::size_t city, const SunSteps& sun, const ShadowField& field) {
        takeDate(m_.made[city], group_, field);
        if (!isMain_) return {};
        std::optional<SampledError> none;
        auto error = sun.steps.empty() ? Result<std::optional<SampledError>>(none)
                                       : measureError(m_, city, receivers_, sun, field);
        if (!error) return tl::make_unexpected(error.error());
        m_.made[city].dateErrors.push_back(*error);
        return {};
    }

    ProgressShare nextShare() {
        const std::size_t all = m_.cities.size() * (1 + m_.dates.size());
        return {progress_, std::min(done_++, all - 1), all};
    }

    Measuring& m_;
    const CellGroup& group_;
    const Receivers& receivers_;
    bool isMain_;
    Progress& progress_;
    std::size_t done_ = 0;
};

// The sweep over all places takes most of the time.
Result<void> measureGroups(Measuring& m, const CellGroup& all, const std::vector<CellGroup>& small) {
    constexpr std::size_t shareOfAll = 10;
    const std::size_t parts = shareOfAll + small.size();
    ProgressShare first(m.progress, 0, parts, shareOfAll);
    if (auto done = GroupMeasure(m, all, true, first).run(); !done) return done;
    for (std::size_t i = 0; i < small.size(); ++i) {
        ProgressShare share(m.progress, shareOfAll + i, parts);
        if (auto done = GroupMeasure(m, small[i], false, share).run(); !done) return done;
    }
    return {};
}

ChosenEngine chooseEngine(const Measuring& m, const Receivers& receivers, const SunSteps& sun,
                          const StepSets& sets) {
    if (sun.steps.empty() || !m.settings().study.engineSettings.empty()) return {};
    const CitySweeps sweeps(m.engine, m.cities, receivers, sun, sets);
    ChosenEngine chosen{std::string(sweeps.chosenKey()), nullptr};
    auto engine = makeEngine(chosen.key);
    if (engine && (*engine)->capabilities().sets) chosen.engine = *std::move(engine);
    return chosen;
}

void chooseEngines(Measuring& m, const Receivers& receivers) {
    m.chosen.push_back(chooseEngine(m, receivers, m.daylight, m.months));
    for (const SunSteps& day : m.dates) m.chosen.push_back(chooseEngine(m, receivers, day, makeOneSet(day)));
}

// What has been done, and the sweeps that follow.
void forecast(Measuring& m, const CellGroup& all, const std::vector<CellGroup>& small) {
    double seconds = m.watch.seconds() + GroupMeasure(m, all, true, m.progress).forecast();
    for (const CellGroup& group : small)
        if (!m.stop.stop_requested()) seconds += GroupMeasure(m, group, false, m.progress).forecast();
    m.made.front().seconds["forecast"] = seconds;
    if (m.takeForecast) m.takeForecast(seconds);
}

bool isBuiltOver(const Measuring& m, const Place& place) {
    constexpr double nothingM2 = 0.01;
    const auto built = findBuiltGround(m.cities, std::span(&place, 1));
    double openM2 = 0;
    for (const Footprint& polygon : findOpenGround(place, built.front())) openM2 += area(polygon);
    return openM2 < nothingM2;
}

// They stay in the tables, without figures.
void listPlacesWithoutCells(Measuring& m) {
    for (std::size_t i = 0; i < m.places().size(); ++i) {
        if (m.made.front().sun[i].cells > 0) continue;
        const Place& place = m.places()[i];
        const auto why = isBuiltOver(m, place) ? NoSunFigures::builtOver : NoSunFigures::betweenCells;
        for (SunByPlace& made : m.made) made.sun[i].why = why;
        m.warnings().push_back(
            {WarningKind::leftOut, fmt::format("a place without figures: {}", describe(why)), place.name});
    }
}

void listPlacesBeyondTerrain(Measuring& m) {
    const auto& terrain = m.cities.front()->terrain;
    if (!terrain) return;
    for (const Place& place : m.places()) {
        const Box2 box = bounds(place);
        if (beyondM(terrain->grid, glm::dvec2(box.low + box.high) / 2.0) > 0)
            m.warnings().push_back({WarningKind::assumed,
                                    "a place beyond the terrain: the nearest elevation is taken",
                                    place.name});
    }
}

// They are measured all the same: a lake may be the place that matters.
Result<void> listPlacesOnWater(Measuring& m, const CellGroup& all) {
    const auto& map = m.cities.front()->context;
    if (!map || std::ranges::none_of(map->areas,
                                     [](const ContextArea& area) { return area.kind == ContextKind::water; }))
        return {};
    const auto dry =
        placeReceiversInPart(*m.cities.front(), m.settings().study.region, all.on.receivers.grid, m.stop);
    if (!dry) return tl::make_unexpected(dry.error());
    for (std::size_t i = 0; i < all.cells.size(); ++i) {
        const auto wet = std::ranges::count_if(
            all.cells[i], [&](const CountedCell& one) { return dry->kind[one.cell] == CellKind::water; });
        if (2 * std::size_t(wet) > all.cells[i].size())
            m.warnings().push_back({WarningKind::assumed,
                                    "a place that lies mostly on water: measured at its surface",
                                    m.places()[i].name});
    }
    return {};
}

Result<void> measure(Measuring& m) {
    std::optional<CellGroup> all;
    std::vector<CellGroup> small;
    const auto place = [&]() -> Result<void> {
        auto placed = placeAll(m);
        if (!placed) return tl::make_unexpected(placed.error());
        all = *std::move(placed);
        auto few = placeSmall(m, *all);
        if (!few) return tl::make_unexpected(few.error());
        small = *std::move(few);
        return {};
    };
    SunByPlace& baseline = m.made.front();
    if (auto done = timeStage(baseline, "receivers", place); !done) return done;
    if (auto done = timeStage(baseline, "sun", [&] { return findSun(m, all->on.receivers); }); !done)
        return done;
    for (SunByPlace& made : m.made) {
        made.months = m.months.names;
        made.seasons = listSeasons(made.months, made.city.frame.origin().latDeg);
        made.daylight = m.daylight;
        made.sun.resize(made.places.size());
    }
    chooseEngines(m, all->on.receivers);
    forecast(m, *all, small);
    if (auto done = measureGroups(m, *all, small); !done) return done;
    for (SunByPlace& made : m.made) made.possibleHours = made.field.sunlitMinutesPerDay / 60;
    listPlacesWithoutCells(m);
    listPlacesBeyondTerrain(m);
    return listPlacesOnWater(m, *all);
}

Result<std::unique_ptr<Engine>> makeSummingEngine(const StudySettings& study, const EngineList& engines) {
    auto engine = makeEngine(study.engine, study.engineSettings, engines);
    if (engine && !(*engine)->capabilities().sets)
        return failure("This engine sums no months", study.engine, "Choose auto, horizon or projected");
    return engine;
}

std::vector<SunByPlace> makeBlank(std::span<const NamedCity> cities, const std::vector<Place>& places,
                                  const SunByPlaceSettings& settings, const std::stop_token& stop) {
    std::vector<SunByPlace> blank;
    const auto wholes = findWholes(places, stop);
    for (const NamedCity& one : cities) {
        blank.push_back({.name = one.name, .city = one.city, .settings = settings, .places = places});
        blank.back().partOf = wholes;
        blank.back().settings.study.region = unite(places);
        blank.back().settings.study.byMonth = true;
    }
    return blank;
}

SunOfCities compareMade(std::vector<SunByPlace> made) {
    SunOfCities all{std::move(made.front()), {}};
    for (std::size_t i = 1; i < made.size(); ++i) {
        auto changes = computeChanges(all.baseline, made[i]);
        all.compared.push_back({std::move(made[i]), std::move(changes)});
    }
    return all;
}

Result<SunOfCities> answerSunByPlace(std::span<const NamedCity> cities, const std::vector<Place>& places,
                                     const SunByPlaceSettings& settings, Progress& progress,
                                     const std::stop_token& stop, const EngineList& engines,
                                     const std::function<void(double)>& takeForecast) {
    if (auto valid = checkSettings(settings, places); !valid) return tl::make_unexpected(valid.error());
    const auto engine = makeSummingEngine(settings.study, engines);
    if (!engine) return tl::make_unexpected(engine.error());
    std::vector<SunByPlace> made = makeBlank(cities, places, settings, stop);
    Measuring m{.cities = {},
                .engine = **engine,
                .made = made,
                .progress = progress,
                .stop = stop,
                .takeForecast = takeForecast};
    for (const NamedCity& one : cities) m.cities.push_back(&one.city);
    if (auto fits = checkMemory(*m.cities.front(), m.settings().study, engines); !fits)
        return tl::make_unexpected(fits.error());
    if (auto done = measure(m); !done) return tl::make_unexpected(done.error());
    made.front().seconds["total"] = m.watch.seconds();
    return compareMade(std::move(made));
}

}  // namespace

std::string_view describe(NoSunFigures why) {
    switch (why) {
        case NoSunFigures::measured:
            return {};
        case NoSunFigures::builtOver:
            return NM_TEXT("buildings stand on all of it");
        case NoSunFigures::betweenCells:
            return NM_TEXT("no cell has its centre on its open ground");
    }
    return {};
}

Result<SunOfCities> compareSunByPlace(std::span<const NamedCity> cities, std::vector<Place> places,
                                      const SunByPlaceSettings& settings, Progress& progress,
                                      std::stop_token stop, const EngineList& engines,
                                      const std::function<void(double)>& forecast) {
    return guardMemory({.advice = "Choose larger cells or fewer places"}, [&] {
        return answerSunByPlace(cities, places, settings, progress, stop, engines, forecast);
    });
}

Result<SunByPlace> runSunByPlace(const City& city, std::vector<Place> places,
                                 const SunByPlaceSettings& settings, Progress& progress, std::stop_token stop,
                                 const EngineList& engines) {
    const NamedCity alone[]{{{}, city}};
    return compareSunByPlace(alone, std::move(places), settings, progress, std::move(stop), engines)
        .map([](SunOfCities&& all) { return std::move(all.baseline); });
}

}  // namespace noonmark
