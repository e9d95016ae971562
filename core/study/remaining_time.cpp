#include "core/study/remaining_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace noonmark {

std::string describeDuration(double seconds) {
    if (seconds < 100) return fmt::format("about {:.0f} s", std::max(1.0, std::round(seconds)));
    if (seconds < 100 * 60) return fmt::format("about {:.0f} min", std::round(seconds / 60));
    return fmt::format("about {:.1f} h", seconds / 3600);
}

std::string describeRemaining(double seconds) {
    if (seconds < 100)
        return fmt::format("about {:.0f} s left", std::max(10.0, std::ceil(seconds / 10) * 10));
    if (seconds < 100 * 60) return fmt::format("about {:.0f} min left", std::ceil(seconds / 60));
    return fmt::format("about {:.1f} h left", seconds / 3600);
}

void PiecewiseProgress::begin(std::string name, double size) {
    name_ = std::move(name);
    size_ = size;
}

void PiecewiseProgress::end() { done_ += std::exchange(size_, 0); }

void PiecewiseProgress::report(double fraction, std::string_view stage) {
    const double here = done_ + std::clamp(fraction, 0.0, 1.0) * size_;
    const double left = whole_ - before_ - here;
    // The first seconds do not show the speed.
    const std::string time = here > 0 && watch_.seconds() > 2
                                 ? ", " + describeRemaining(watch_.seconds() / here * left)
                                 : std::string();
    progress_.report((before_ + here) / whole_, fmt::format("{}{}: {}", name_, time, stage));
}

}  // namespace noonmark
