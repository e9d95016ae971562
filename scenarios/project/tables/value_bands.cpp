#include "scenarios/project/tables/value_bands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

double largestOf(std::span<const float> values) {
    double largest = 0;
    for (const float value : values)
        if (!std::isnan(value)) largest = std::max(largest, std::abs(double(value)));
    return largest;
}

}  // namespace

ValueBands::ValueBands(std::span<const float> values, const std::string& unit, bool change)
    : scale_(legendScale(largestOf(values))),
      change_(change),
      each_(int(std::lround(scale_.top / scale_.tick))) {
    const double tick = scale_.tick;
    for (int i = change ? -each_ : 0; i < each_; ++i) {
        const double middle = (i + 0.5) * tick / scale_.top;
        bands_.push_back({i * tick, (i + 1) * tick, change ? impactRgb(middle) : shadowRgb(middle),
                          fmt::format("{:g} to {:g} {}", i * tick, (i + 1) * tick, unit)});
    }
}

int ValueBands::bandOf(float value) const {
    if (std::isnan(value) || (change_ && value == 0)) return -1;
    const int fromZero = std::min(each_ - 1, int(std::abs(double(value)) / scale_.tick));
    if (!change_) return fromZero;
    return value > 0 ? each_ + fromZero : each_ - 1 - fromZero;
}

}  // namespace noonmark
