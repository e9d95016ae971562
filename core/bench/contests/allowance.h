#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "core/base/stopwatch.h"

namespace noonmark::bench {

/// The time that an experiment may take, from when it is made. What an experiment cannot do without is
/// measured all the same; what more there could be is left out where it does not fit in, and that is said.
class Allowance {
public:
    explicit Allowance(double seconds = std::numeric_limits<double>::infinity()) : seconds_(seconds) {}

    [[nodiscard]] double leftS() const { return seconds_ - watch_.seconds(); }

private:
    double seconds_;
    Stopwatch watch_;
};

/// Which of some pieces of work fit into `seconds` together, the cheapest first. `costs` in seconds.
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
