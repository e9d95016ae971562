#include "core/engines/horizon/counting/run_search.h"

#include <utility>

namespace noonmark {

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
        first_ = first;
        isHidden_.assign(known - first, 0);
        search(first, known);
        first = known = known + 1;
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
    if (foundLit_)
        if (const auto lit = litFromMiddle(first, end, true)) return lit;
    if (const auto lit = litFromMiddle(first, end, false)) return lit;
    return rays_.findLit ? rays_.findLit(first, end) : std::nullopt;
}

// Decides the doubtful steps, from the middle outwards, until one is lit. `onlyLitBins`: only those in bins
// where a step was found lit.
std::optional<std::uint32_t> RunSearch::litFromMiddle(std::uint32_t first, std::uint32_t end,
                                                      bool onlyLitBins) {
    const std::uint32_t middle = first + (end - first) / 2;
    for (std::uint32_t off = 0; off <= middle - first; ++off) {
        if (isLit(middle - off, onlyLitBins)) return middle - off;
        if (off > 0 && middle + off < end && isLit(middle + off, onlyLitBins)) return middle + off;
    }
    return std::nullopt;
}

// Asks a ray if the horizons leave that in doubt and no ray has answered yet.
bool RunSearch::isLit(std::uint32_t step, bool onlyLitBins) {
    const auto [bin, sun] = steps_[step].place;
    if (onlyLitBins && isLitBin_[bin] == 0) return false;
    const bool doubtful = horizons_.lowest[bin] <= sun || (rays_.findLit && isLitBin_[bin] != 0);
    std::uint8_t& isHidden = isHidden_[step - first_];
    if (!doubtful || isHidden != 0) return false;
    isHidden = rays_.hidden(step) ? 1 : 0;
    return isHidden == 0;
}

void RunSearch::noteLit(std::uint32_t step) {
    isLitBin_[steps_[step].place.bin] = 1;
    foundLit_ = true;
}

}  // namespace noonmark
