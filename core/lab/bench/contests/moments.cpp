#include "core/lab/bench/contests/moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace noonmark::bench {

Moments computeMoments(std::vector<double> values) {
    if (values.empty()) return {};
    std::ranges::sort(values);
    Moments moments;
    const std::size_t count = values.size();
    for (const double value : values) moments.mean += value / double(count);
    for (const double value : values)
        moments.deviation += (value - moments.mean) * (value - moments.mean) / double(count);
    moments.deviation = std::sqrt(moments.deviation);
    moments.median = (values[count / 2] + values[(count - 1) / 2]) / 2;
    moments.minimum = values.front();
    moments.maximum = values.back();
    return moments;
}

std::string formatThreeDigits(double value) {
    return std::abs(value) >= 100 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

}  // namespace noonmark::bench
