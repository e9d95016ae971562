#include "app/gui/tools/live/live_follower.h"

#include <chrono>
#include <utility>

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

}  // namespace noonmark
