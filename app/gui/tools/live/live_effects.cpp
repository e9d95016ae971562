#include "app/gui/tools/live/live_effects.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "core/receivers/points/solid_parts.h"

namespace noonmark {

namespace {

using namespace std::chrono_literals;
constexpr auto restTime = 300ms;
constexpr auto ageTime = 250ms;

}  // namespace

LiveFollower::LiveFollower(std::shared_ptr<SharedHorizonCache> horizons, QObject* parent)
    : QObject(parent), horizons_(std::move(horizons)) {
    rest_.setSingleShot(true);
    rest_.setInterval(restTime);
    age_.setInterval(ageTime);
    connect(&rest_, &QTimer::timeout, this, &LiveFollower::rested);
    connect(&age_, &QTimer::timeout, this, [this] {
        if (answer_ && newerThanShown_.isValid()) Q_EMIT aged();
    });
}

void LiveFollower::begin(LivePlace place, const LiveQuestion& question) {
    end();
    start_ = std::make_shared<const Start>(Start{std::move(place), question});
}

void LiveFollower::end() {
    rest_.stop();
    age_.stop();
    slot_.drop();
    start_.reset();
    live_.reset();
    answer_.reset();
    newerThanShown_.invalidate();
}

double LiveFollower::ageSeconds() const {
    return newerThanShown_.isValid() ? double(newerThanShown_.elapsed()) / 1000 : 0;
}

// A running count of continuous shadow is of an older shape: it is cancelled.
void LiveFollower::follow(const LiveReceivers::Shape& shape) {
    if (!start_) return;
    shape_ = shape;
    rest_.stop();
    for (QElapsedTimer* newer : {&newerThanAsked_, &newerThanShown_})
        if (!newer->isValid()) newer->start();
    if (!slot_.busy() || asked_ == ShadowCounts::grossAndRuns) ask(ShadowCounts::gross);
}

void LiveFollower::ask(ShadowCounts counts) {
    asked_ = counts;
    newerThanAsked_.invalidate();
    age_.start();
    slot_.start<Followed>(
        tr("Live shadow"),
        [start = start_, live = live_, horizons = horizons_, shape = shape_, counts](
            Progress& progress, const std::stop_token& stop) -> Result<Followed> {
            auto at = live ? Result<std::shared_ptr<LiveShadow>>(live)
                           : LiveShadow::at(start->place, start->question, horizons, progress, stop);
            if (!at) return tl::make_unexpected(at.error());
            auto answer = (*at)->with(shape, counts, progress, stop);
            if (!answer) return tl::make_unexpected(answer.error());
            return Followed{*std::move(at), *std::move(answer)};
        },
        [this](Result<Followed> followed) { take(std::move(followed)); });
}

void LiveFollower::take(Result<Followed> followed) {
    if (!followed) {
        end();
        return Q_EMIT failed(followed.error());
    }
    live_ = std::move(followed->live);
    answer_ = std::make_shared<const LiveAnswer>(std::move(followed->answer));
    newerThanShown_ = newerThanAsked_;
    if (newerThanAsked_.isValid()) {
        ask(ShadowCounts::gross);
    } else {
        age_.stop();
        rest_.start();
    }
    Q_EMIT changed();
}

void LiveFollower::rested() {
    const bool missing = answer_ && answer_->engine == LiveEngine::horizons && !answer_->runs;
    if (missing && !slot_.busy()) ask(ShadowCounts::grossAndRuns);
}

namespace {

/// The city with the shape, and the buildings whose facades are measured.
struct FacadeScene {
    City city;
    std::vector<std::uint32_t> measured;
};

template <class Keeps>
FacadeScene makeScene(const FacadeQuestion& question, Keeps keeps) {
    FacadeScene scene{.city = {.frame = question.rest->frame, .terrain = question.rest->terrain}};
    const auto add = [&](const std::shared_ptr<const Building>& building, bool measured) {
        if (measured) scene.measured.push_back(std::uint32_t(scene.city.buildings.size()));
        scene.city.buildings.push_back(building);
    };
    for (const auto& building : question.rest->buildings) {
        const bool chosen = std::ranges::find(question.neighbours, building) != question.neighbours.end();
        if (chosen || keeps(*building)) add(building, chosen);
    }
    for (const auto& building : question.shape) add(building, true);
    return scene;
}

double wallAreaM2(const FacadeScene& scene) {
    double area = 0;
    for (const std::uint32_t index : scene.measured)
        for (const Part& part : scene.city.buildings[index]->parts)
            for (const WallFace& face : findWallFaces(part)) area += face.lengthM * (face.highM - face.lowM);
    return area;
}

FacadeSettings coarsened(FacadeSettings facades, double areaM2, std::size_t points) {
    const double times = std::sqrt(areaM2 / (facades.bayM * facades.storeyM) / double(points));
    if (times <= 1) return facades;
    facades.bayM = std::min(facades.bayM * times, FacadeSettings::maxM);
    facades.storeyM = std::min(facades.storeyM * times, FacadeSettings::maxM);
    facades.aboveFloorM = facades.storeyM / 2;
    return facades;
}

OwnStoreys scaled(OwnStoreys storeys, double times) {
    for (auto& [id, metres] : storeys) metres = std::min(metres * times, FacadeSettings::maxM);
    return storeys;
}

Result<FacadeAnswer> measure(FacadeScene scene, const FacadeSettings& facades, const OwnStoreys& storeys,
                             const SunSteps& sun, Progress& progress, const std::stop_token& stop) {
    ElementStudy study;
    study.city = std::move(scene.city);
    auto receivers = placeOnFacades(study.city, scene.measured, facades, stop, storeys);
    if (!receivers) return tl::make_unexpected(receivers.error());
    study.receivers = *std::move(receivers);
    study.sun = sun;
    auto minutes = sweepPoints(study.city, study.receivers.points, sun, progress, stop,
                               {.runs = true, .decidesRuns = false});
    if (!minutes) return tl::make_unexpected(minutes.error());
    study.minutes = *std::move(minutes);
    return FacadeAnswer{.map = makeElementMap(study),
                        .facades = facades,
                        .buildSeconds = study.minutes.cost.seconds["build"],
                        .sweepSeconds = study.minutes.cost.seconds["sweep"]};
}

/// Whether a building counts while the shape moves.
class NearShape {
public:
    explicit NearShape(const FacadeQuestion& question) {
        for (const auto* list : {&question.shape, &question.neighbours})
            for (const auto& building : *list) add(*building);
    }
    bool operator()(const Building& building) const {
        const Box2 box = bounds(building);
        const glm::vec2 gap = glm::max(glm::max(box.low - box_.high, box_.low - box.high), glm::vec2(0));
        const double distance = double(glm::length(gap));
        static const double tangent = std::tan(Degrees{nearHorizonDeg}.radians().value);
        return distance < nearM || double(topM(building)) - lowM_ > tangent * distance;
    }

private:
    void add(const Building& building) {
        box_.add(bounds(building));
        for (const Part& part : building.parts) lowM_ = std::min(lowM_, double(part.bottomM));
    }
    Box2 box_;
    double lowM_ = 1e30;
};

}  // namespace

Result<FacadeAnswer> measureFacades(const FacadeQuestion& question, Progress& progress,
                                    const std::stop_token& stop) {
    return measure(makeScene(question, [](const Building&) { return true; }), question.facades,
                   question.storeys, *question.sun, progress, stop);
}

Result<FacadeAnswer> measureFacadesCoarsely(const FacadeQuestion& question, std::size_t points,
                                            Progress& progress, const std::stop_token& stop) {
    FacadeScene scene = makeScene(question, NearShape(question));
    const FacadeSettings facades = coarsened(question.facades, wallAreaM2(scene), points);
    const OwnStoreys storeys = scaled(question.storeys, facades.storeyM / question.facades.storeyM);
    return measure(std::move(scene), facades, storeys, *question.sun, progress, stop)
        .map([](FacadeAnswer answer) {
            answer.coarse = true;
            return answer;
        });
}

namespace {

constexpr std::chrono::milliseconds facadeRest{300};
constexpr std::size_t firstPoints = 100, fewestPoints = 24, maxPoints = 4000;

Result<std::shared_ptr<const SunSteps>> findSun(const FacadeQuestion& question, const SunQuestion& sun,
                                                const std::stop_token& stop) {
    if (question.sun) return question.sun;
    return computeDaylightSteps(sun.period, sun.observer, stop).map([](SunSteps steps) {
        return std::make_shared<const SunSteps>(std::move(steps));
    });
}

}  // namespace

LiveFacades::LiveFacades(QObject* parent) : QObject(parent), points_(firstPoints) {
    rest_.setSingleShot(true);
    rest_.setInterval(facadeRest);
    connect(&rest_, &QTimer::timeout, this, [this] {
        if (!slot_.busy()) ask(false);
    });
}

void LiveFacades::begin(City rest, const SunQuestion& sun, const FacadeSettings& facades) {
    end();
    sun_ = sun;
    question_ = FacadeQuestion{.rest = std::make_shared<const City>(std::move(rest)), .facades = facades};
}

void LiveFacades::end() {
    rest_.stop();
    slot_.drop();
    question_.reset();
    answer_.reset();
    newer_ = false;
}

// A running measurement of every bay is of an older shape: it is cancelled.
void LiveFacades::follow(const FacadeQuestion::Buildings& shape, const FacadeQuestion::Buildings& neighbours,
                         const OwnStoreys& storeys) {
    if (!question_) return;
    question_->shape = shape;
    question_->neighbours = neighbours;
    question_->storeys = storeys;
    rest_.stop();
    newer_ = true;
    if (!slot_.busy() || !coarse_) ask(true);
}

void LiveFacades::ask(bool coarse) {
    coarse_ = coarse;
    newer_ = false;
    slot_.start<Followed>(
        tr("Live facades"),
        [question = *question_, sun = sun_, coarse, points = points_](
            Progress& progress, const std::stop_token& stop) mutable -> Result<Followed> {
            auto steps = findSun(question, sun, stop);
            if (!steps) return tl::make_unexpected(steps.error());
            question.sun = *steps;
            auto answer = coarse ? measureFacadesCoarsely(question, points, progress, stop)
                                 : measureFacades(question, progress, stop);
            if (!answer) return tl::make_unexpected(answer.error());
            return Followed{*std::move(steps), *std::move(answer)};
        },
        [this](Result<Followed> followed) { take(std::move(followed)); });
}

void LiveFacades::take(Result<Followed> followed) {
    if (!followed) {
        end();
        return Q_EMIT failed(followed.error());
    }
    question_->sun = std::move(followed->sun);
    answer_ = std::make_shared<const FacadeAnswer>(std::move(followed->answer));
    if (answer_->coarse) fitBudget(*answer_);
    if (newer_)
        ask(true);
    else if (answer_->coarse)
        rest_.start();
    Q_EMIT changed();
}

void LiveFacades::fitBudget(const FacadeAnswer& answer) {
    const auto measured = double(std::max<std::size_t>(1, answer.map.elements.size()));
    const double secondsOfPoint = std::max(answer.sweepSeconds / measured, 1e-7);
    const double fits = std::max(0.0, budgetSeconds - answer.buildSeconds) / secondsOfPoint;
    points_ = std::size_t(std::clamp(fits, double(fewestPoints), double(maxPoints)));
}

}  // namespace noonmark
