#include "core/study/by_place/sun_by_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/memory_guard.h"
#include "core/base/progress_share.h"
#include "core/base/rising_progress.h"
#include "core/base/stopwatch.h"
#include "core/describe/text.h"
#include "core/measures/error_sample.h"
#include "core/study/by_place/city_sweeps.h"
#include "core/study/by_place/place_errors.h"
#include "core/study/by_place/place_parts.h"
#include "core/study/by_place/place_warnings.h"
#include "core/study/by_place/sum_places.h"
#include "core/study/memory_need.h"
#include "core/study/terrain_coverage.h"
#include "core/sun/zone_question.h"

namespace noonmark {

namespace {

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
    std::function<void(double)> takeForecast{};  ///< empty: none is wanted
    std::optional<Observer> observer{};          ///< of a tile; none: in the middle of the places
    Stopwatch watch{};
    /// For the cells of all places, over the period and on each date. Small places are measured by the same.
    std::vector<ChosenEngine> chosen{};
    std::vector<SampledOff> off{};         ///< samples after which the engine was changed for a closer one
    std::vector<ComparedSets> compared{};  ///< the period in the cities sampled so far
    std::vector<std::vector<double>> smallOff{};  ///< of each city: how far means of small places are off

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
        Period day = study.period;
        day.start = date;
        day.days = 1;
        auto ofDay = computeSunSteps(day, observer, m.stop);
        if (!ofDay) return tl::make_unexpected(ofDay.error());
        m.dates.push_back(*std::move(ofDay));
    }
    return questionGround(m, receivers);
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

bool wantsErrors(const Measuring& m) {
    return m.settings().study.errorSample.receivers > 0 && m.settings().study.engine != referenceEngine;
}

// Of small places rays are traced to some in a few groups: each group needs a scene of its own.
constexpr std::size_t sampledSmallGroups = 3;

ErrorSampleSettings sampleOf(const Measuring& m, bool isMain) {
    constexpr int least = 8;  // cells
    ErrorSampleSettings sample = m.settings().study.errorSample;
    if (!isMain)
        sample.receivers = std::max<decltype(sample.receivers)>(least, sample.receivers / sampledSmallGroups);
    return sample;
}

/// Holds the figures of places against rays, in one city after the other.
class PlaceErrors {
public:
    PlaceErrors(Measuring& m, const CellGroup& group, bool isMain)
        : m_(m), receivers_(group.on.receivers), wanted_(wantsErrors(m)) {
        if (wanted_) places_ = samplePlaces(group, sampleOf(m, isMain), m.daylight.steps.size());
    }

    /// Of small places; their differences are stated together with those of other groups.
    Result<void> takeSmall(std::size_t city, const ShadowBreakdown& sums) {
        if (!wanted_) return {};
        const SunlitTime time{m_.daylight.sunlitMinutes(), countDays(m_.daylight), 0};
        const auto compared = compare(city, m_.daylight, sums);
        if (!compared) return warn(m_.made[city], compared.error());
        std::vector<double>& off = m_.smallOff[city];
        std::ranges::copy(listMeanDifferences(places_, *compared, time), std::back_inserter(off));
        return {};
    }

    Result<void> takePeriod(std::size_t city, const ShadowBreakdown& sums) {
        if (!wanted_) return {};
        SunByPlace& made = m_.made[city];
        const SunlitTime time{m_.daylight.sunlitMinutes(), countDays(m_.daylight), made.settings.enoughHours};
        auto compared = compare(city, m_.daylight, sums);
        if (!compared) return warn(made, compared.error());
        if (made.error) {
            const ShownError cells = listErrors(*made.error, false).front();
            made.errors.push_back(
                {findErrorFacts("cell_sun"), {}, cells.mean, cells.p99, cells.largest, cells.count});
        }
        append(made, listPeriodErrors(places_, *compared, time));
        if (city > 0 && !m_.compared.empty())
            append(made,
                   listChangeErrors(places_, m_.compared.front(), *compared, time, made.settings.lossMin));
        m_.compared.push_back(*std::move(compared));
        return {};
    }

    Result<void> takeDate(std::size_t city, const SunSteps& sun, const ShadowBreakdown& sums,
                          const CivilDate& date) {
        if (!wanted_) return {};
        SunByPlace& made = m_.made[city];
        const SunlitTime time{sun.sunlitMinutes(), {1}, made.settings.enoughHours};
        const auto compared = compare(city, sun, sums);
        if (!compared) return warn(made, compared.error());
        append(made, listDateErrors(places_, *compared, time, formatText(date)));
        return {};
    }

private:
    Result<ComparedSets> compare(std::size_t city, const SunSteps& sun, const ShadowBreakdown& sums) {
        NoProgress quiet;
        return compareSets(*m_.cities[city], receivers_, sun, sums, places_.cells, quiet, m_.stop);
    }

    static void append(SunByPlace& made, std::vector<ShownError> errors) {
        std::ranges::move(errors, std::back_inserter(made.errors));
    }

    // A missing error fails nothing.
    static Result<void> warn(SunByPlace& made, const Error& error) {
        if (isCancelled(error)) return tl::make_unexpected(error);
        made.warnings.push_back(
            {WarningKind::leftOut, "the error of places against the ray reference", error.text()});
        return {};
    }

    Measuring& m_;
    const Receivers& receivers_;
    bool wanted_;
    SampledPlaces places_;
};

/// Measures the places of one group in all cities.
class GroupMeasure {
public:
    /// The main group is sampled, too.
    GroupMeasure(Measuring& m, const CellGroup& group, bool isMain, Progress& progress, bool isSampled = true)
        : m_(m),
          group_(group),
          receivers_(group.on.receivers),
          isMain_(isMain),
          isSampled_(isSampled),
          progress_(progress) {}

    Result<void> run() {
        if (isSampled_) errors_.emplace(m_, group_, isMain_);
        if (auto done = timeStage(m_.made.front(), "accumulate", [&] { return sweepMonths(); }); !done)
            return done;
        for (std::size_t date = 0; date < m_.dates.size(); ++date)
            if (auto done = timeStage(m_.made.front(), "dates", [&] { return sweepDate(date); }); !done)
                return done;
        return {};
    }

    /// Seconds that run() is expected to take, if no sample is off.
    [[nodiscard]] double forecast() const {
        double seconds = CitySweeps(engineOf(0), m_.cities, receivers_, m_.daylight, m_.months)
                             .forecast(keyOf(0), sampledOver(m_.daylight));
        for (std::size_t date = 0; date < m_.dates.size(); ++date) {
            const SunSteps& day = m_.dates[date];
            if (day.steps.empty() || m_.stop.stop_requested()) continue;
            const StepSets one = makeOneSet(day);
            seconds += CitySweeps(engineOf(date + 1), m_.cities, receivers_, day, one)
                           .forecast(keyOf(date + 1), sampledOver(day));
        }
        return seconds;
    }

private:
    // Cells that rays are traced to in each city: the sample, and half as many in places.
    [[nodiscard]] std::size_t sampledOver(const SunSteps& sun) const {
        const std::size_t places = sampleSize(sampleOf(m_, isMain_), sun.steps.size()) / 2;
        if (isMain_) return places * 3;
        return isSampled_ && &sun == &m_.daylight ? places : 0;
    }

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
                --done_;  // the same again
                continue;
            }
            if (auto taken = takeErrors(0, *first); !taken) return taken;
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
            if (auto taken = takeErrors(city, *sums); !taken) return taken;
        }
        return {};
    }

    Result<void> takeErrors(std::size_t city, const ShadowBreakdown& sums) {
        if (!errors_) return {};
        const Stopwatch watch;
        auto taken = isMain_ ? errors_->takePeriod(city, sums) : errors_->takeSmall(city, sums);
        m_.made[city].seconds["error_sample"] += watch.seconds();
        return taken;
    }

    Result<void> take(std::size_t city, const ShadowBreakdown& sums) {
        SunByPlace& made = m_.made[city];
        const MeanDay day = averageDay(sums, m_.daylight);
        takeMonths(made, group_, sums, day);
        if (!isMain_) return {};
        ShadowField field = makeField(sums, day, receivers_, m_.daylight);
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
            for (std::size_t city = 0; city < m_.cities.size(); ++city) takeSunlessDay(city);
            return {};
        }
        CitySweeps sweeps(engineOf(date + 1), m_.cities, receivers_, sun, one);
        std::optional<ShadowBreakdown> first;
        for (std::size_t city = 0; city < m_.cities.size(); ++city) {
            ProgressShare share = nextShare();
            auto sums = city == 0 ? sweeps.sweepFirst(share, m_.stop)
                                  : sweeps.sweepOther(city, *first, share, m_.stop);
            if (!sums) return tl::make_unexpected(sums.error());
            if (auto taken = takeDay(city, sun, *sums); !taken) return taken;
            if (isMain_ && errors_)
                if (auto taken = errors_->takeDate(city, sun, *sums, m_.settings().dates[date]); !taken)
                    return taken;
            if (city == 0) first = *std::move(sums);
        }
        return {};
    }

    void takeSunlessDay(std::size_t city) {
        takeDate(m_.made[city], group_, {std::vector<float>(receivers_.cells.size()), 0});
        if (isMain_) m_.made[city].dateErrors.emplace_back();
    }

    Result<void> takeDay(std::size_t city, const SunSteps& sun, const ShadowBreakdown& sums) {
        const MeanDay day = averageDay(sums, sun);
        takeDate(m_.made[city], group_, day);
        if (!isMain_) return {};
        auto error = measureError(m_, city, receivers_, sun, makeField(sums, day, receivers_, sun));
        if (!error) return tl::make_unexpected(error.error());
        m_.made[city].dateErrors.push_back(*error);
        return {};
    }

    ProgressShare nextShare() { return {progress_, done_++, m_.cities.size() * (1 + m_.dates.size())}; }

    Measuring& m_;
    const CellGroup& group_;
    const Receivers& receivers_;
    bool isMain_, isSampled_;
    Progress& progress_;
    std::optional<PlaceErrors> errors_;  // if it is sampled
    std::size_t done_ = 0;
};

// Those of small places are spread over the city.
bool isSampled(std::size_t group, std::size_t groups) {
    return group % ((groups + sampledSmallGroups - 1) / sampledSmallGroups) == 0;
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
        if (auto done = GroupMeasure(m, cells.all, true, first).run(); !done) return done;
    for (std::size_t i = 0; i < cells.small.size(); ++i) {
        ProgressShare share(m.progress, shareOfAll + i, parts);
        GroupMeasure group(m, cells.small[i], false, share, isSampled(i, cells.small.size()));
        if (auto done = group.run(); !done) return done;
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
void forecast(Measuring& m, const PlaceCells& cells) {
    double seconds = m.watch.seconds() + GroupMeasure(m, cells.all, true, m.progress).forecast();
    for (std::size_t i = 0; i < cells.small.size() && !m.stop.stop_requested(); ++i)
        seconds +=
            GroupMeasure(m, cells.small[i], false, m.progress, isSampled(i, cells.small.size())).forecast();
    m.made.front().seconds["forecast"] = seconds;
    if (m.takeForecast) m.takeForecast(seconds);
}

void setSun(SunByPlace& sun, SunSteps daylight) {
    sun.months = monthsOf(daylight).names;
    sun.seasons = listSeasons(sun.months, sun.city.frame.origin().latDeg);
    sun.possibleHours = daylight.sunlitMinutes() / double(daylight.dayCount()) / 60;
    sun.daylight = std::move(daylight);
}

Result<void> measure(Measuring& m) {
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
    if (auto done = timeStage(baseline, "receivers", place); !done) return done;
    if (auto done = timeStage(baseline, "sun", [&] { return findSun(m, cells.all.on.receivers); }); !done)
        return done;
    for (SunByPlace& made : m.made) {
        setSun(made, m.daylight);
        made.sun.resize(made.places.size());
    }
    chooseEngines(m, cells.all.on.receivers);
    forecast(m, cells);
    if (auto done = measureGroups(m, cells); !done) return done;
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
                                     const std::function<void(double)>& takeForecast,
                                     const std::optional<Observer>& observer = {}) {
    if (auto valid = checkSettings(settings, places); !valid) return tl::make_unexpected(valid.error());
    const auto engine = makeSummingEngine(settings.study, engines);
    if (!engine) return tl::make_unexpected(engine.error());
    std::vector<SunByPlace> made = makeBlank(cities, places, settings, stop);
    RisingProgress rising(progress);
    Measuring m{.cities = {},
                .engine = **engine,
                .made = made,
                .progress = rising,
                .stop = stop,
                .takeForecast = takeForecast,
                .observer = observer};
    for (const NamedCity& one : cities) m.cities.push_back(&one.city);
    if (auto fits = checkMemory(*m.cities.front(), m.settings().study, engines); !fits)
        return tl::make_unexpected(fits.error());
    if (auto done = measure(m); !done) return tl::make_unexpected(done.error());
    made.front().seconds["total"] = m.watch.seconds();
    return compareMade(std::move(made));
}

}  // namespace

Result<SunOfCities> compareSunByPlace(std::span<const NamedCity> cities, std::vector<Place> places,
                                      const SunByPlaceSettings& settings, Progress& progress,
                                      std::stop_token stop, const EngineList& engines,
                                      const std::function<void(double)>& forecast) {
    return guardMemory({.advice = "Choose larger cells or fewer places"}, [&] {
        return answerSunByPlace(cities, places, settings, progress, stop, engines, forecast);
    });
}

Result<SunOfCities> measurePlacesOfTile(std::span<const NamedCity> cities, std::vector<Place> places,
                                        const SunByPlaceSettings& settings, const Observer& observer,
                                        Progress& progress, std::stop_token stop, const EngineList& engines) {
    return guardMemory({.advice = "Choose smaller tiles or larger cells"}, [&] {
        return answerSunByPlace(cities, places, settings, progress, stop, engines, {}, observer);
    });
}

Result<void> frameSun(SunByPlace& sun, const Observer& observer, const std::stop_token& stop) {
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
