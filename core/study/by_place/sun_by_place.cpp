#include "core/study/by_place/sun_by_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/city/trees/tree.h"
#include "core/describe/field_values.h"
#include "core/describe/text.h"
#include "core/engines/shade_trees.h"
#include "core/study/by_place/group_measure.h"
#include "core/study/by_place/place_errors.h"
#include "core/study/by_place/sum_places.h"
#include "core/study/study_cost.h"
#include "core/study/terrain_coverage.h"
#include "core/sun/zone_country.h"

namespace noonmark {

namespace {

Result<void> checkSettings(const SunByPlaceSettings& settings, const std::vector<Place>& places) {
    if (places.empty())
        return failure("There is no place to measure", "places",
                       "Choose other kinds of places, or read a file of places");
    if (auto valid = checkRanges(sunByPlaceFields().of(settings)); !valid) return valid;
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

// A tile knows too little of the terrain and the places to judge them.
Result<void> questionGround(Measuring& m, const Receivers& receivers) {
    if (m.observer) return {};
    const City& city = *m.cities.front();
    const StudySettings& study = m.settings().study;
    const TerrainCoverage coverage = computeTerrainCoverage(city, receivers, m.daylight);
    for (Warning& warning : makeWarnings(coverage)) m.warnings().push_back(std::move(warning));
    const Box2 box = bounds(study.region);
    const LonLat middle = city.frame.lonLatFromLocal(glm::dvec2(box.low + box.high) / 2.0);
    if (auto question = questionZone(study.period, middle)) m.warnings().push_back(*std::move(question));
    return checkCoverage(coverage, study.region.name);
}

Result<void> findSun(Measuring& m, const Receivers& receivers) {
    const StudySettings& study = m.settings().study;
    const Observer observer = m.observer.value_or(makeObserver(*m.cities.front(), study));
    auto sun = computeDaylightSteps(study.period, observer, m.stop);
    if (!sun) return tl::make_unexpected(sun.error());
    m.daylight = *std::move(sun);
    m.months = monthsOf(m.daylight);
    for (const CivilDate& date : m.settings().dates) {
        auto ofDay = computeSunSteps(periodOf(m.settings(), date), observer, m.stop);
        if (!ofDay) return tl::make_unexpected(ofDay.error());
        m.dates.push_back(*std::move(ofDay));
    }
    return questionGround(m, receivers);
}

// The sampled ones are spread over the city.
MeasuredGroup smallGroup(const PlaceCells& cells, std::size_t i) {
    const std::size_t groups = cells.small.size();
    const std::size_t stride = (groups + sampledSmallGroups - 1) / sampledSmallGroups;
    return {cells.small[i], false, i % stride == 0};
}

void addSmallErrors(Measuring& m) {
    for (std::size_t city = 0; city < m.made.size(); ++city)
        if (!m.smallOff[city].empty())
            m.made[city].errors.push_back(sumUpError("place_small", std::move(m.smallOff[city])));
}

// The sweep over all places takes most of the time.
Result<void> measureGroups(Measuring& m, const PlaceCells& cells) {
    constexpr std::size_t shareOfAll = 10;
    const std::size_t parts = shareOfAll + cells.small.size();
    m.smallOff.resize(m.made.size());
    ProgressShare first(m.progress, 0, parts, shareOfAll);
    if (!cells.all.on.receivers.cells.empty())
        if (auto done = measureGroup(m, {cells.all}, first); !done) return done;
    for (std::size_t i = 0; i < cells.small.size(); ++i) {
        ProgressShare share(m.progress, shareOfAll + i, parts);
        if (auto done = measureGroup(m, smallGroup(cells, i), share); !done) return done;
    }
    addSmallErrors(m);
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

// None where no cell is there to choose for.
void chooseEngines(Measuring& m, const Receivers& receivers) {
    if (receivers.cells.empty()) return m.chosen.resize(1 + m.dates.size());
    m.chosen.push_back(chooseEngine(m, receivers, m.daylight, m.months));
    for (const SunSteps& day : m.dates) m.chosen.push_back(chooseEngine(m, receivers, day, makeOneSet(day)));
}

// What has been done, and the sweeps that follow.
double forecast(Measuring& m, const PlaceCells& cells) {
    double seconds = m.watch.seconds() + forecastGroup(m, {cells.all});
    for (std::size_t i = 0; i < cells.small.size() && !m.stop.stop_requested(); ++i)
        seconds += forecastGroup(m, smallGroup(cells, i));
    return seconds;
}

void setSun(SunByPlace& sun, SunSteps daylight) {
    sun.months = monthsOf(daylight).names;
    sun.seasons = listSeasons(sun.months, sun.city.frame.origin().latDeg);
    sun.possibleHours = daylight.sunlitMinutes() / double(daylight.dayCount()) / 60;
    sun.daylight = std::move(daylight);
}

bool hasWantedTrees(const Measuring& m) {
    return m.settings().study.trees != TreeColumns::without &&
           std::ranges::any_of(m.cities,
                               [](const City* city) { return city->trees && !city->trees->trees.empty(); });
}

void addColumns(SunByPlace& made) {
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        if (isAmong(made.settings.study.trees, column))
            made.withTrees.push_back({column, std::vector<SunOfPlace>(made.places.size())});
}

// The cells, the sun over them, and the engines that will measure them.
Result<PlaceCells> prepare(Measuring& m) {
    PlaceCells cells;
    const auto place = [&]() -> Result<void> {
        auto placed = placeCells(m.cities, m.places(), m.settings(), m.stop);
        if (!placed) return tl::make_unexpected(placed.error());
        cells = *std::move(placed);
        if (cells.all.on.receivers.cells.empty() && !m.observer)
            return failure("No cell of the places lies on open ground", "places", "Choose smaller cells");
        return {};
    };
    SunByPlace& baseline = m.made.front();
    if (auto done = timeStage(baseline, "receivers", place); !done) return tl::make_unexpected(done.error());
    if (auto done = timeStage(baseline, "sun", [&] { return findSun(m, cells.all.on.receivers); }); !done)
        return tl::make_unexpected(done.error());
    m.hasTrees = hasWantedTrees(m);
    chooseEngines(m, cells.all.on.receivers);
    return cells;
}

Result<void> measure(Measuring& m, const PlaceCells& cells) {
    for (SunByPlace& made : m.made) {
        setSun(made, m.daylight);
        made.sun.resize(made.places.size());
        if (m.hasTrees) addColumns(made);
    }
    const double seconds = forecast(m, cells);
    m.made.front().seconds["forecast"] = seconds;
    if (m.takeForecast) m.takeForecast(seconds);
    if (auto done = measureGroups(m, cells); !done) return done;
    if (!m.treesReached)
        for (SunByPlace& made : m.made) made.withTrees.clear();
    return warnOfPlaces(m.cities, m.made, cells.all, m.stop);
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

// Of a baseline without trees those of the scenario that plants some are measured, too.
void stateHowTreesWereMeasured(std::vector<SunByPlace>& made) {
    const auto known =
        std::ranges::find_if(made, [](const SunByPlace& one) { return !one.treesHow.empty(); });
    if (known != made.end() && made.front().treesHow.empty()) made.front().treesHow = known->treesHow;
}

SunOfCities compareMade(std::vector<SunByPlace> made) {
    stateHowTreesWereMeasured(made);
    SunOfCities all{std::move(made.front()), {}};
    for (std::size_t i = 1; i < made.size(); ++i) {
        auto changes = computeChanges(all.baseline, made[i]);
        auto withTrees = computeChangesWithTrees(all.baseline, made[i]);
        all.compared.push_back({std::move(made[i]), std::move(changes), std::move(withTrees)});
    }
    return all;
}

/// What is asked, and the way it is answered.
struct AskedSun {
    std::span<const NamedCity> cities;
    const std::vector<Place>& places;
    const SunByPlaceSettings& settings;
    Progress& progress;
    const std::stop_token& stop;
    const EngineList& engines;
    std::function<void(double)> takeForecast{};
    std::optional<Observer> observer{};
};

// `use`: of a Measuring and the cells.
template <class Use>
auto usePrepared(const AskedSun& asked, Use&& use)
    -> std::invoke_result_t<Use, Measuring&, const PlaceCells&> {
    if (auto valid = checkSettings(asked.settings, asked.places); !valid)
        return tl::make_unexpected(valid.error());
    const auto engine = makeSummingEngine(asked.settings.study, asked.engines);
    if (!engine) return tl::make_unexpected(engine.error());
    std::vector<SunByPlace> made = makeBlank(asked.cities, asked.places, asked.settings, asked.stop);
    RisingProgress rising(asked.progress);
    Measuring m{.cities = {},
                .engine = **engine,
                .made = made,
                .progress = rising,
                .stop = asked.stop,
                .takeForecast = asked.takeForecast,
                .observer = asked.observer};
    for (const NamedCity& one : asked.cities) m.cities.push_back(&one.city);
    if (auto fits = checkMemory(*m.cities.front(), m.settings().study, asked.engines); !fits)
        return tl::make_unexpected(fits.error());
    const auto cells = prepare(m);
    if (!cells) return tl::make_unexpected(cells.error());
    return std::forward<Use>(use)(m, *cells);
}

Result<SunOfCities> answerSunByPlace(const AskedSun& asked) {
    return usePrepared(asked, [](Measuring& m, const PlaceCells& cells) -> Result<SunOfCities> {
        if (auto done = measure(m, cells); !done) return tl::make_unexpected(done.error());
        m.made.front().seconds["total"] = m.watch.seconds();
        return compareMade(std::move(m.made));
    });
}

SunForecast makeForecast(Measuring& m, const PlaceCells& cells) {
    const std::string& chosen = m.chosen.front().key;
    return {.seconds = forecast(m, cells),
            .cells = cells.all.on.receivers.cells.size(),
            .steps = m.daylight.steps.size(),
            .engine = chosen.empty() ? m.settings().study.engine : chosen};
}

}  // namespace

Period periodOf(const SunByPlaceSettings& settings, const std::optional<CivilDate>& date) {
    Period period = settings.study.period;
    if (!date) return period;
    period.start = *date;
    period.days = 1;
    return period;
}

Result<SunOfCities> compareSunByPlace(std::span<const NamedCity> cities, std::vector<Place> places,
                                      const SunByPlaceSettings& settings, Progress& progress,
                                      std::stop_token stop, const EngineList& engines,
                                      const std::function<void(double)>& forecast) {
    return guardMemory({.advice = "Choose larger cells or fewer places"}, [&] {
        return answerSunByPlace({cities, places, settings, progress, stop, engines, forecast});
    });
}

Result<SunForecast> forecastSunByPlace(std::span<const NamedCity> cities, const std::vector<Place>& places,
                                       const SunByPlaceSettings& settings, const std::stop_token& stop,
                                       const EngineList& engines) {
    NoProgress quiet;
    return guardMemory({.advice = "Choose larger cells or fewer places"}, [&] {
        return usePrepared({cities, places, settings, quiet, stop, engines},
                           [&](Measuring& m, const PlaceCells& cells) -> Result<SunForecast> {
                               SunForecast forecast = makeForecast(m, cells);
                               if (stop.stop_requested()) return cancelled();
                               return forecast;
                           });
    });
}

Result<SunOfCities> measurePlacesOfTile(std::span<const NamedCity> cities, std::vector<Place> places,
                                        const SunByPlaceSettings& settings, const Observer& observer,
                                        Progress& progress, std::stop_token stop, const EngineList& engines) {
    return guardMemory({.advice = "Choose smaller tiles or larger cells"}, [&] {
        return answerSunByPlace({cities, places, settings, progress, stop, engines, {}, observer});
    });
}

Result<void> prepareSunByPlace(SunByPlace& sun, const Observer& observer, const std::stop_token& stop) {
    sun.settings.study.region = unite(sun.places);
    sun.settings.study.byMonth = true;
    sun.partOf = findWholes(sun.places, stop);
    auto daylight = computeDaylightSteps(sun.settings.study.period, observer, stop);
    if (!daylight) return tl::make_unexpected(daylight.error());
    setSun(sun, *std::move(daylight));
    return {};
}

Result<SunByPlace> runSunByPlace(const City& city, std::vector<Place> places,
                                 const SunByPlaceSettings& settings, Progress& progress, std::stop_token stop,
                                 const EngineList& engines) {
    const NamedCity alone[]{{{}, city}};
    return compareSunByPlace(alone, std::move(places), settings, progress, std::move(stop), engines)
        .map([](SunOfCities&& all) { return std::move(all.baseline); });
}

}  // namespace noonmark
