#include "app/gui/session/study/run_estimate.h"

#include <QLocale>
#include <QTimer>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/input/all_engines.h"
#include "core/engines/auto_engine.h"
#include "core/engines/shade_trees.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/elements/element_study.h"

namespace noonmark {

namespace {

constexpr double worthComparing = 60;  // seconds of rays from which their time is stated
constexpr double graphEdges = 295;     // of a year of 2,190 hours at 5 deg
constexpr double fewRays = 5e10;       // less than a minute by all engines but rays

// How many times as fast as rays an engine is over one hour, as measured in docs/benchmarks.md.
double speedOverRays(std::string_view engine) {
    if (engine == "iam") return 6.5;
    if (engine == "sam") return 6;
    return 1;
}

// Hours that look alike are computed once.
double viaGraph(std::string_view engine, double raySeconds, double hours) {
    return raySeconds * std::min(1.0, graphEdges / std::max(hours, 1.0)) / speedOverRays(engine);
}

struct KnownSeconds {
    std::string_view engine;
    double EstimatedSeconds::*seconds;
};
constexpr std::array knownSeconds{KnownSeconds{referenceEngine, &EstimatedSeconds::ray},
                                  KnownSeconds{"projected", &EstimatedSeconds::projected},
                                  KnownSeconds{"horizon", &EstimatedSeconds::horizon}};

// Engines without an estimate of their own are those that go through the graph.
double secondsOfEngine(std::string_view engine, const EstimatedSeconds& seconds, double hours) {
    const auto known = std::ranges::find(knownSeconds, engine, &KnownSeconds::engine);
    return known != knownSeconds.end() ? seconds.*known->seconds : viaGraph(engine, seconds.ray, hours);
}

// Months take another pass by the engine of the field where it sums them, else by the sweep without longest
// runs; contributions such a sweep of about twice the time (horizon_breakdown.h).
double breakdownSeconds(const StudySettings& settings, std::string_view engine, EngineLoad load) {
    load.runs = false;
    const EstimatedSeconds seconds = estimateSeconds(load);
    if (settings.contributions) return 2 * seconds.horizon;
    if (!settings.byMonth) return 0;
    return engine == "projected" ? seconds.projected : seconds.horizon;
}

// All engines of studies find longest runs, too.
TreeSeconds treeSeconds(const City& city, const StudySettings& settings, const Receivers& receivers,
                        const SunSteps& sun) {
    if (settings.trees == TreeColumns::without) return {};
    return estimateTreeSeconds(city, receivers, sun, ShadowCounts::grossAndRuns);
}

QString nameOfEngine(std::string_view key) {
    const EngineEntry* entry = findEngine(allEngines(), key);
    if (!entry) return {};
    return translated(entry->info.name);
}

QString describeCells(double cells) {
    if (cells < 1e6) return QLocale().toString(std::round(cells), 'f', 0);
    return QObject::tr("%1 million").arg(QLocale().toString(cells / 1e6, 'f', 1));
}

QString describeSize(const RunEstimate& estimate) {
    const int form = pluralNumber(quint64(estimate.receivers));
    const QString receivers =
        estimate.points ? QObject::tr("%1 point(s)", "", form) : QObject::tr("%1 cell(s)", "", form);
    const QString steps = QObject::tr("%1 position(s) of the sun", "", pluralNumber(quint64(estimate.steps)));
    return QStringLiteral("%1, %2.").arg(receivers.arg(describeCells(estimate.receivers)),
                                         steps.arg(describeCells(estimate.steps)));
}

}  // namespace

Result<RunEstimate> estimateRun(const City& city, const StudySettings& settings,
                                const std::stop_token& stop) {
    const auto receivers = placeReceivers(city, settings.region, settings.receivers, stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    const auto sun = computeSunSteps(settings.period, makeObserver(city, settings), stop);
    if (!sun) return tl::make_unexpected(sun.error());
    const std::array cities{&city};
    const EngineLoad load = measureEngineLoad(cities, *receivers, *sun, HorizonSweepSettings());
    const EstimatedSeconds seconds = estimateSeconds(load);
    const double sunlitHours = sun->sunlitMinutes() / 60;
    const auto chosen = AutoEngine().choose(cities, *receivers, *sun);
    RunEstimate estimate{
        .receivers = double(load.receivers),
        .steps = double(load.steps),
        .raySeconds = seconds.ray,
        .quickerSeconds = chosen ? secondsOfEngine(chosen->key, seconds, sunlitHours) : seconds.ray};
    const std::string_view engine =
        settings.engine == "auto" && chosen ? chosen->key : std::string_view(settings.engine);
    estimate.seconds = secondsOfEngine(engine, seconds, sunlitHours);
    const double further = breakdownSeconds(settings, engine, load);
    const TreeSeconds trees = treeSeconds(city, settings, *receivers, *sun);
    const double quickerTrees = std::min(trees.rays, trees.sweep);
    estimate.seconds += further + (engine == referenceEngine ? trees.rays : quickerTrees);
    estimate.quickerSeconds += further + quickerTrees;
    estimate.raySeconds += trees.rays;
    estimate.engine = nameOfEngine(engine);
    return estimate;
}

Result<RunEstimate> estimateRun(const City& city, const StudySettings& settings,
                                const ElementSettings& elements, Progress& progress,
                                const std::stop_token& stop) {
    const auto forecast = forecastElementStudy(city, settings, elements, progress, stop);
    if (!forecast) return tl::make_unexpected(forecast.error());
    RunEstimate estimate{.receivers = double(forecast->points),
                         .points = true,
                         .steps = double(forecast->steps),
                         .raySeconds = forecast->raySeconds,
                         .quickerSeconds = forecast->horizonSeconds};
    const bool rays = settings.engine == referenceEngine;
    estimate.seconds = rays ? estimate.raySeconds : estimate.quickerSeconds;
    estimate.engine = rays ? nameOfEngine(referenceEngine) : QObject::tr("Horizons of the points");
    return estimate;
}

Result<RunEstimate> estimateRun(const PlacesRun& run, const std::stop_token& stop) {
    std::vector<NamedCity> cities;
    for (const auto& city : run.cities) cities.push_back({{}, *city});
    return forecastSunByPlace(cities, run.places, run.settings, stop).map([](const SunForecast& forecast) {
        return RunEstimate{.receivers = double(forecast.cells),
                           .steps = double(forecast.steps),
                           .seconds = forecast.seconds,
                           .engine = nameOfEngine(forecast.engine)};
    });
}

bool measuresPoints(const StudySettings& settings) {
    return settings.engineSettings.empty() &&
           (settings.engine == "auto" || settings.engine == "horizon" || settings.engine == referenceEngine);
}

bool mayBeLong(const StudySettings& settings) {
    if (settings.engine == referenceEngine) return true;
    const double areaM2 = area(settings.region.polygons);
    const double hours = settings.period.window ? 24 : std::max(settings.period.hours, 1.0);
    const double steps = settings.period.days * hours * 60 / settings.period.stepMinutes;
    return areaM2 / (settings.receivers.cellM * settings.receivers.cellM) * steps > fewRays;
}

QString describe(const RunEstimate& estimate) {
    const QString size = describeSize(estimate);
    const QString run = QObject::tr("%1: %2.").arg(estimate.engine, describeAbout(estimate.seconds));
    if (estimate.raySeconds < std::max(worthComparing, 2 * estimate.seconds))
        return size + QLatin1Char(' ') + run;
    return QObject::tr("%1 %2 Rays would take %3.").arg(size, run, describeAbout(estimate.raySeconds));
}

QString describeAbout(double seconds) {
    struct Unit {
        double seconds;
        QString words;
    };
    const Unit units[] = {{86400, QObject::tr("days")},
                          {3600, QObject::tr("h")},
                          {60, QObject::tr("min")},
                          {1, QObject::tr("s")}};
    for (const Unit& unit : units)
        if (seconds >= 2 * unit.seconds)
            return QObject::tr("about %1 %2").arg(std::round(seconds / unit.seconds)).arg(unit.words);
    return QObject::tr("about a second");
}

namespace {
constexpr int forecastRestMs = 300;
}

RunForecast::RunForecast(QObject* parent) : QObject(parent), rest_(new QTimer(this)) {
    rest_->setSingleShot(true);
    rest_->setInterval(forecastRestMs);
    connect(rest_, &QTimer::timeout, this, &RunForecast::ask);
}

void RunForecast::setCity(std::shared_ptr<const City> city) {
    if (city == city_) return;
    city_ = std::move(city);
    askSoon();
}

void RunForecast::setSettings(const StudySettings& settings, const std::optional<ElementSettings>& elements) {
    if (!places_ && settings == settings_ && elements == elements_) return;
    settings_ = settings;
    elements_ = elements;
    places_.reset();
    askSoon();
}

void RunForecast::setPlaces(PlacesRun run) {
    if (places_ == run) return;
    places_ = std::move(run);
    askSoon();
}

void RunForecast::askSoon() {
    slot_.drop();
    estimate_.reset();
    refusal_.clear();
    Q_EMIT changed();
    rest_->start();
}

void RunForecast::ask() {
    const bool isEmpty = places_ ? places_->cities.empty() || places_->places.empty()
                                 : !city_ || settings_.region.polygons.empty();
    if (isEmpty) return;
    slot_.start<RunEstimate>(
        tr("Estimating"),
        [city = city_, settings = settings_, elements = elements_, places = places_](
            Progress& progress, const std::stop_token& stop) {
            if (places) return estimateRun(*places, stop);
            return elements ? estimateRun(*city, settings, *elements, progress, stop)
                            : estimateRun(*city, settings, stop);
        },
        [this](const Result<RunEstimate>& made) {
            if (made) estimate_ = *made;
            if (!made && !isCancelled(made.error())) refusal_ = describeError(made.error());
            Q_EMIT changed();
        });
}

}  // namespace noonmark
