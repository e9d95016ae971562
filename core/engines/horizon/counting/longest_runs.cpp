#include "core/engines/horizon/counting/longest_runs.h"

#include <bit>
#include <numeric>
#include <utility>

#include "core/engines/ray/ray_reference.h"

namespace noonmark {

LongestRuns::Found LongestRuns::of(std::span<const RunLanes> horizons) const {
    Found found;
    for (std::uint32_t i = 0; i < days_.size(); ++i) {
        const RunLanes before = found.longest;
        walk(horizons, days_[i], found.longest);
        for (std::size_t lane = 0; lane < lanesPerPart; ++lane)
            if (found.longest.values[lane] > before.values[lane]) found.day[lane] = i;
    }
    return found;
}

StepRun LongestRuns::run(std::span<const RunLanes> horizons, std::size_t lane, std::uint32_t day,
                         int length) const {
    const DaySteps& steps = days_[day];
    std::uint32_t run = 0;
    for (std::uint32_t step = steps.first; step < steps.end; ++step) {
        const StepPlace& place = steps_[step].place;
        run = horizons[place.bin].values[lane] > place.sun ? run + 1 : 0;
        if (run == std::uint32_t(length)) return {step + 1 - run, step + 1};
    }
    return {};
}

void LongestRuns::ofEachDay(std::span<const RunLanes> horizons, std::vector<RunLanes>& longest) const {
    longest.assign(days_.size(), {});
    for (std::size_t i = 0; i < days_.size(); ++i) walk(horizons, days_[i], longest[i]);
}

int LongestRuns::searched(std::size_t lane, std::span<const RunLanes> maximum, RunSearch& search) const {
    std::vector<std::uint32_t> order;
    for (std::uint32_t day = 0; day < days_.size(); ++day)
        if (maximum[day].values[lane] > search.longest()) order.push_back(day);
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [&](std::uint32_t day) { return maximum[day].values[lane]; });
    for (const std::uint32_t day : order) {
        if (maximum[day].values[lane] <= search.longest()) break;
        search.walk(days_[day]);
    }
    return search.longest();
}

void RunSearch::begin(Rays rays, std::span<const TimedStep> steps, int atLeast) {
    rays_ = std::move(rays);
    steps_ = steps;
    longest_ = std::uint32_t(std::max(0, atLeast));
    foundLit_ = false;
    isLitBin_.assign(horizons_.highest.size(), 0);
}

// A run longer than `longest_` that begins at `first` or later contains the step `longest_` after it. If that
// step, or one between, is certainly lit, the run begins after it: most steps are never looked at.
void RunSearch::walk(const DaySteps& day) {
    std::uint32_t first = day.first;
    std::uint32_t known = first;  // steps [first, known) may be hidden
    while (first + longest_ < day.end) {
        const std::uint32_t end = first + longest_ + 1;
        std::uint32_t begin = end;
        while (begin > known && mayBeHidden(begin - 1)) --begin;
        const bool isLitBefore = begin > known;
        known = end;
        if (isLitBefore) {
            first = begin;
            continue;
        }
        while (known < day.end && mayBeHidden(known)) ++known;
        findDoubts(first, known);
        search(first, known);
        first = known = known + 1;
    }
}

void RunSearch::findDoubts(std::uint32_t first, std::uint32_t end) {
    doubts_.clear();
    for (std::uint32_t step = first; step < end; ++step) {
        const StepPlace& place = steps_[step].place;
        if (horizons_.lowest[place.bin] <= place.sun)
            doubts_.push_back({step, place.bin, horizons_.own[place.bin] <= place.sun});
    }
}

// No step of [first, end) is known to be lit.
void RunSearch::search(std::uint32_t first, std::uint32_t end) {
    while (first < end && end - first > longest_) {
        const auto lit = litIn(first, end);
        if (!lit) {
            longest_ = end - first;
            return;
        }
        noteLit(*lit);
        search(first, *lit);
        first = *lit + 1;
    }
}

std::optional<std::uint32_t> RunSearch::litIn(std::uint32_t first, std::uint32_t end) {
    const auto from = std::ranges::lower_bound(doubts_, first, {}, &Doubt::step),
               to = std::ranges::lower_bound(from, doubts_.end(), end, {}, &Doubt::step);
    const std::span<Doubt> doubts(from, to);
    const std::uint32_t middle = first + (end - first) / 2;
    for (const Which which : {Which::inLitBins, Which::probablyLit, Which::all}) {
        if (which == Which::inLitBins && !foundLit_) continue;
        if (const auto lit = litFromMiddle(doubts, middle, which)) return lit;
    }
    return rays_.findLit ? rays_.findLit(first, end) : std::nullopt;
}

bool RunSearch::isWanted(const Doubt& doubt, Which which) const {
    if (doubt.isHidden) return false;
    if (which == Which::inLitBins) return isLitBin_[doubt.bin] != 0;
    return which == Which::all || doubt.isProbablyLit;
}

// Asks rays about the doubtful steps, from the middle outwards, until one is lit.
std::optional<std::uint32_t> RunSearch::litFromMiddle(std::span<Doubt> doubts, std::uint32_t middle,
                                                      Which which) {
    auto after = std::ranges::upper_bound(doubts, middle, {}, &Doubt::step), before = after;
    while (before != doubts.begin() || after != doubts.end()) {
        const bool isBefore =
            after == doubts.end() ||
            (before != doubts.begin() && middle - std::prev(before)->step <= after->step - middle);
        Doubt& doubt = isBefore ? *--before : *after++;
        if (!isWanted(doubt, which)) continue;
        if (!rays_.hidden(doubt.step)) return doubt.step;
        doubt.isHidden = true;
    }
    return std::nullopt;
}

void RunSearch::noteLit(std::uint32_t step) {
    isLitBin_[steps_[step].place.bin] = 1;
    foundLit_ = true;
}

Result<RunRays> RunRays::over(const City& city, std::span<const std::uint32_t> used,
                              const Receivers& receivers, const SunSteps& sun, bool checksRuns,
                              const std::stop_token& stop) {
    auto scene = RayScene::over(city, used, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    return RunRays(*std::move(scene), findOpenBelow(city, used), receivers, sun, checksRuns);
}

RunRays::Receiver RunRays::of(std::uint32_t cell) const {
    return {*this, placeRayOrigin(receivers_.position(cell))};
}

bool RunRays::Receiver::hidden(std::uint32_t step) const {
    rays_->decided_->rays.fetch_add(1, std::memory_order_relaxed);
    return rays_->scene_.occluded(origin_, rays_->sun_.steps[step].direction);
}

std::uint32_t RunRays::Receiver::findLit(std::span<const std::uint32_t> steps) const {
    DirectionPacket packet{.count = int(steps.size())};
    for (std::size_t lane = 0; lane < together; ++lane) {
        const glm::vec3 direction = rays_->sun_.steps[steps[std::min(lane, steps.size() - 1)]].direction;
        packet.x[lane] = direction.x;
        packet.y[lane] = direction.y;
        packet.z[lane] = direction.z;
    }
    std::uint32_t blocked = 0;
    rays_->scene_.blockedLanes({&origin_, 1}, packet, {&blocked, 1});
    rays_->decided_->rays.fetch_add(steps.size(), std::memory_order_relaxed);
    return ~blocked & std::uint32_t((1ULL << steps.size()) - 1);
}

std::optional<std::uint32_t> RunRays::Receiver::findLit(std::uint32_t first, std::uint32_t end) const {
    std::array<std::uint32_t, together> steps;
    for (; first < end; first += std::uint32_t(together)) {
        std::iota(steps.begin(), steps.end(), first);
        const std::uint32_t lit =
            findLit(std::span(steps).first(std::min<std::size_t>(together, end - first)));
        if (lit != 0) return first + std::uint32_t(std::countr_zero(lit));
    }
    return std::nullopt;
}

RunSearch::Rays RunRays::Receiver::forSearch() const {
    RunSearch::Rays rays;
    rays.hidden = [*this](std::uint32_t step) { return hidden(step); };
    if (rays_->checkRuns())
        rays.findLit = [*this](std::uint32_t first, std::uint32_t end) { return findLit(first, end); };
    return rays;
}

}  // namespace noonmark
