#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "core/base/stopwatch.h"

namespace noonmark::bench {

/// The time limit of an experiment, counted from construction. Necessary measurements are made in any case;
/// optional ones are left out if they do not fit, and the report states that.
class Allowance {
public:
    explicit Allowance(double seconds = std::numeric_limits<double>::infinity()) : seconds_(seconds) {}

    [[nodiscard]] double leftS() const { return seconds_ - watch_.seconds(); }

private:
    double seconds_;
    Stopwatch watch_;
};

/// Which pieces of work fit into `seconds` together, the cheapest first. `costs` in seconds.
inline std::vector<bool> canAfford(const std::vector<double>& costs, double seconds) {
    std::vector<std::size_t> order(costs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return costs[i]; });
    std::vector<bool> fits(costs.size());
    for (const std::size_t i : order) {
        fits[i] = costs[i] <= seconds;
        if (fits[i]) seconds -= costs[i];
    }
    return fits;
}

}  // namespace noonmark::bench
