#include "core/study/by_place/sun_by_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/memory_guard.h"
#include "core/base/progress_share.h"
#include "core/base/stopwatch.h"
#include "core/engines/api/blank_field.h"
#include "core/engines/common/engine_in_use.h"
#include "core/measures/place_receivers.h"
#include "core/measures/take_error.h"
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

/// What the cities have in common.
struct Common {
    std::vector<const City*> cities;  ///< the first is the baseline
    const Engine& engine;
    PlaceReceivers on{};
    std::vector<std::vector<CountedCell>> cells{};  ///< of each place
    SunSteps daylight{};
    Warnings warnings{};
};

/// What is measured, in the course of it.
struct Measuring {
    const City& city;
    const Common& common;
    SunByPlace& made;
    Progress& progress;
    std::stop_token stop;
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
    return validate(settings.study.period).map([](const auto&) {});
}

Region unite(const std::vector<Place>& places) {
    Region region{.name = "places", .polygons = {}};
    for (const Place& place : places)
        region.polygons.insert(region.polygons.end(), place.polygons.begin(), place.polygons.end());
    return region;
}

Result<void> placeCells(Common& common, const SunByPlace& made, const std::stop_token& stop) {
    auto on = placeReceiversOnPlaces(common.cities, made.places, made.settings.study.receivers, stop);
    if (!on) return tl::make_unexpected(on.error());
    common.on = *std::move(on);
    if (common.on.receivers.cells.empty())
        return failure("No cell of the places lies on open ground", "places", "Choose smaller cells");
    for (std::size_t i = 0; i < made.places.size(); ++i) common.cells.push_back(listCells(common.on, i));
    return {};
}

Result<void> findSun(Common& common, const StudySettings& study, const std::stop_token& stop) {
    const City& city = *common.cities.front();
    auto sun = computeDaylightSteps(study.period, makeObserver(city, study), stop);
    if (!sun) return tl::make_unexpected(sun.error());
    common.daylight = *std::move(sun);
    const TerrainCoverage coverage = computeTerrainCoverage(city, common.on.receivers, common.daylight);
    for (Warning& warning : makeWarnings(coverage)) common.warnings.push_back(std::move(warning));
    const Box2 box = bounds(study.region);
    const LonLat middle = city.frame.lonLatFromLocal(glm::dvec2(box.low + box.high) / 2.0);
    if (auto question = questionZone(study.period, middle)) common.warnings.push_back(*std::move(question));
    return checkCoverage(coverage, study.region.name);
}

// Minutes a day in shadow, from the minutes of all sets.
ShadowField fieldOf(const ShadowBreakdown& sums, const Receivers& receivers, const SunSteps& sun) {
    ShadowField field = makeBlankField(receivers, sun);
    std::ranges::fill(field.continuousMin, std::numeric_limits<float>::quiet_NaN());
    for (const std::uint32_t cell : receivers.cells) {
        double minutes = 0;
        for (const auto& ofSet : sums.minutes) minutes += double(ofSet[cell]);
        field.grossMin[cell] = float(minutes / double(sun.dayCount()));
    }
    field.engine = sums.engine;
    return field;
}

// A failure to measure the error does not fail the study; only a stop request ends it.
Result<void> measureError(Measuring& m) {
    m.made.error.reset();
    const ErrorSampleSettings& sample = m.made.settings.study.errorSample;
    if (sample.receivers == 0 || m.made.settings.study.engine == referenceEngine) return {};
    return takeError(
        sampleError(m.city, m.common.on.receivers, m.made.daylight, m.made.field, sample, m.progress, m.stop),
        m.made.error, m.made.warnings);
}

Result<ShadowBreakdown> sweep(const Measuring& m, const EngineInUse& engine, const StepSets& sets) {
    return engine.breakDown(m.city, sets, false, m.progress, m.stop);
}

// By the engine in use, and by those that it goes on to while samples are off by more than it aims at.
Result<ShadowBreakdown> sweepMonths(Measuring& m) {
    EngineInUse engine(m.common.engine, m.common.cities, m.common.on.receivers, m.made.daylight);
    const StepSets months = monthsOf(m.made.daylight);
    for (;;) {
        const Stopwatch watch;
        auto sums = sweep(m, engine, months);
        m.made.seconds["accumulate"] += watch.seconds();
        if (!sums) return sums;
        m.made.field = fieldOf(*sums, m.common.on.receivers, m.made.daylight);
        auto checked = timeStage(m.made, "error_sample", [&] { return measureError(m); });
        if (!checked) return tl::make_unexpected(checked.error());
        if (!m.made.error || !engine.goOn(m.made.error->grossOff())) return sums;
    }
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

SunOfPlace summarize(const Measuring& m, const std::vector<CountedCell>& cells) {
    SunOfPlace sun;
    const ShadowField& field = m.made.field;
    if (cells.empty()) return sun;
    const auto hours = [&](std::uint32_t cell) { return hoursAt(field, cell); };
    const AreaSums sums = sumUp(cells, m.made.settings.enoughHours, hours);
    sun.areaM2 = sums.cells * field.grid.cellM * field.grid.cellM;
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

void addMonths(Measuring& m, const ShadowBreakdown& sums) {
    m.made.months = sums.sets.names;
    const std::vector<double> days = countDays(m.made.daylight, m.made.months);
    for (std::size_t place = 0; place < m.common.cells.size(); ++place)
        for (std::size_t month = 0; month < m.made.months.size(); ++month) {
            const auto hours = [&](std::uint32_t cell) {
                return (sums.sunlitMinutes[month] - double(sums.minutes[month][cell])) / 60 / days[month];
            };
            const AreaSums all = sumUp(m.common.cells[place], 0, hours);
            m.made.sun[place].monthHours.push_back(all.hours / all.cells);
        }
}

// A day on which the sun does not rise leaves every cell without sun.
Result<void> addDate(Measuring& m, const CivilDate& date) {
    Period day = m.made.settings.study.period;
    day.start = date;
    day.days = 1;
    auto sun = computeSunSteps(day, makeObserver(m.city, m.made.settings.study), m.stop);
    if (!sun) return tl::make_unexpected(sun.error());
    ShadowField field = makeBlankField(m.common.on.receivers, *sun);
    if (!sun->steps.empty()) {
        const EngineInUse engine(m.common.engine, m.common.cities, m.common.on.receivers, *sun);
        const auto sums = sweep(m, engine, makeOneSet(*sun));
        if (!sums) return tl::make_unexpected(sums.error());
        field = fieldOf(*sums, m.common.on.receivers, *sun);
    }
    for (std::size_t place = 0; place < m.common.cells.size(); ++place) {
        const auto hours = [&](std::uint32_t cell) { return hoursAt(field, cell); };
        const AreaSums sums = sumUp(m.common.cells[place], m.made.settings.enoughHours, hours);
        m.made.sun[place].dateHours.push_back(sums.hours / sums.cells);
        m.made.sun[place].belowShare.push_back(1 - sums.enough / sums.cells);
    }
    return {};
}

void listPlacesWithoutCells(Measuring& m) {
    for (std::size_t i = 0; i < m.common.cells.size(); ++i)
        if (m.common.cells[i].empty())
            m.made.warnings.push_back(
                {WarningKind::leftOut, "a place without a cell on open ground", m.made.places[i].name});
}

Result<void> measure(Measuring& m) {
    const auto sums = sweepMonths(m);
    if (!sums) return tl::make_unexpected(sums.error());
    for (const auto& cells : m.common.cells) m.made.sun.push_back(summarize(m, cells));
    addMonths(m, *sums);
    for (const CivilDate& date : m.made.settings.dates)
        if (auto done = timeStage(m.made, "dates", [&] { return addDate(m, date); }); !done) return done;
    m.made.possibleHours = m.made.field.sunlitMinutesPerDay / 60;
    listPlacesWithoutCells(m);
    return {};
}

Result<void> prepare(Common& common, SunByPlace& baseline, const EngineList& engines,
                     const std::stop_token& stop) {
    baseline.settings.study.region = unite(baseline.places);
    baseline.settings.study.byMonth = true;
    if (auto fits = checkMemory(*common.cities.front(), baseline.settings.study, engines); !fits) return fits;
    if (auto done = timeStage(baseline, "receivers", [&] { return placeCells(common, baseline, stop); });
        !done)
        return done;
    return timeStage(baseline, "sun", [&] { return findSun(common, baseline.settings.study, stop); });
}

Result<std::unique_ptr<Engine>> makeSummingEngine(const StudySettings& study, const EngineList& engines) {
    auto engine = makeEngine(study.engine, study.engineSettings, engines);
    if (engine && !(*engine)->capabilities().sets)
        return failure("This engine sums no months", study.engine, "Choose auto, horizon or projected");
    return engine;
}

Result<SunByPlace> measureCity(SunByPlace made, const Common& common, Progress& progress,
                               const std::stop_token& stop) {
    const Stopwatch watch;
    made.daylight = common.daylight;
    made.warnings = common.warnings;
    const City city = made.city;
    Measuring m{.city = city, .common = common, .made = made, .progress = progress, .stop = stop};
    if (auto done = measure(m); !done) return tl::make_unexpected(done.error());
    made.seconds["total"] = watch.seconds() + made.seconds["receivers"] + made.seconds["sun"];
    return made;
}

Result<SunOfCities> answerSunByPlace(std::span<const NamedCity> cities, std::vector<Place> places,
                                     const SunByPlaceSettings& settings, Progress& progress,
                                     const std::stop_token& stop, const EngineList& engines) {
    if (auto valid = checkSettings(settings, places); !valid) return tl::make_unexpected(valid.error());
    const auto engine = makeSummingEngine(settings.study, engines);
    if (!engine) return tl::make_unexpected(engine.error());
    Common common{.cities = {}, .engine = **engine};
    for (const NamedCity& one : cities) common.cities.push_back(&one.city);
    SunByPlace blank{.settings = settings, .places = std::move(places)};
    if (auto ready = prepare(common, blank, engines, stop); !ready) return tl::make_unexpected(ready.error());
    SunOfCities all;
    for (std::size_t i = 0; i < cities.size(); ++i) {
        ProgressShare share(progress, i, cities.size());
        blank.name = cities[i].name;
        blank.city = cities[i].city;
        auto made = measureCity(blank, common, share, stop);
        if (!made) return tl::make_unexpected(made.error());
        if (i == 0)
            all.baseline = *std::move(made);
        else
            all.compared.push_back({*std::move(made), {}});
        if (i == 0) blank.seconds.clear();
    }
    for (ComparedSun& one : all.compared) one.changes = computeChanges(all.baseline, one.sun);
    return all;
}

}  // namespace

Result<SunOfCities> compareSunByPlace(std::span<const NamedCity> cities, std::vector<Place> places,
                                      const SunByPlaceSettings& settings, Progress& progress,
                                      std::stop_token stop, const EngineList& engines) {
    return guardMemory({.advice = "Choose larger cells or fewer places"}, [&] {
        return answerSunByPlace(cities, std::move(places), settings, progress, stop, engines);
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
