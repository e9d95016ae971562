#include "app/gui/session/study/shared_horizon_cache.h"

#include <chrono>
#include <utility>

namespace noonmark {

namespace {

using Lock = std::unique_lock<std::timed_mutex>;
constexpr std::chrono::milliseconds glance{20};

// Waits for the lock; returns without it when stopped.
Lock lockUnlessStopped(std::timed_mutex& mutex, const std::stop_token& stop) {
    Lock lock(mutex, std::defer_lock);
    while (!stop.stop_requested())
        if (lock.try_lock_for(glance)) break;
    return lock;
}

bool same(const City& a, const City& b) { return a.terrain == b.terrain && a.buildings == b.buildings; }

}  // namespace

Result<ShadowField> SharedHorizonCache::field(const City& city, const Receivers& receivers,
                                              const SunQuestion& question, ShadowCounts counts,
                                              Progress& progress, const std::stop_token& stop) {
    const Lock lock = lockUnlessStopped(mutex_, stop);
    if (!lock) return cancelled();
    if (const auto set = setSun(question, stop); !set) return tl::make_unexpected(set.error());
    if (const auto set = setGrid(city, receivers); !set) return tl::make_unexpected(set.error());
    auto field = counted(city, receivers, counts, progress, stop);
    note(city, receivers, field);
    return field;
}

void SharedHorizonCache::forget() {
    const Lock lock(mutex_);
    state_.reset();
    counted_ = false;
}

Result<void> SharedHorizonCache::setSun(const SunQuestion& question, const std::stop_token& stop) {
    if (question_ == question) return {};
    auto sun = computeDaylightSteps(question.period, question.observer, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    sun_ = *std::move(sun);
    question_ = question;
    counted_ = false;
    return {};
}

Result<void> SharedHorizonCache::setGrid(const City& city, const Receivers& receivers) {
    // A new set starts with its period; otherwise horizons would first be swept for another period, and then
    // again.
    if (state_ && state_->grid == receivers.grid && state_->flat == receivers.flat() &&
        state_->city.terrain == city.terrain)
        return {};
    state_.reset();
    counted_ = false;
    auto made = HorizonCache::make(city, receivers, {binDeg, memoryBytes});
    if (!made) return tl::make_unexpected(made.error());
    state_.emplace(State{*std::move(made), receivers.grid, receivers.flat(), true, city, receivers.kind});
    ++sets_;
    return {};
}

// The sun is set before the buildings change, since a change needs a period.
Result<ShadowField> SharedHorizonCache::counted(const City& city, const Receivers& receivers,
                                                ShadowCounts counts, Progress& progress,
                                                const std::stop_token& stop) {
    HorizonCache& horizons = state_->horizons;
    const bool otherCity = !state_->known || !same(state_->city, city) || state_->kind != receivers.kind;
    if (!counted_ || (!otherCity && counts == ShadowCounts::gross)) {
        auto field = horizons.computePeriod(sun_, progress, stop, otherCity ? ShadowCounts::gross : counts);
        if (!field || !otherCity) return field;
        counted_ = true;
    }
    return otherCity ? horizons.change(city, receivers, progress, stop, counts)
                     : horizons.withRuns(progress, stop);
}

// After a stop the horizons may belong to either city and have no period; after an error they cannot be
// reused.
void SharedHorizonCache::note(const City& city, const Receivers& receivers,
                              const Result<ShadowField>& field) {
    counted_ = field.has_value();
    if (!field && !isCancelled(field.error())) return state_.reset();
    state_->known = field.has_value();
    if (!field) return;
    state_->city = city;
    state_->kind = receivers.kind;
}

}  // namespace noonmark
