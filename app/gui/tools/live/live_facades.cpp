#include "app/gui/tools/live/live_facades.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace noonmark {

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
