#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "core/stopwatch.h"

namespace noonmark::bench {

/// The time that an experiment may take, from when it is made. What an experiment cannot do without is
/// measured all the same; what more there could be is left out, and that is said, where it would take longer.
class Allowance {
public:
    explicit Allowance(double seconds = std::numeric_limits<double>::infinity()) : seconds_(seconds) {}

    [[nodiscard]] double leftS() const { return seconds_ - watch_.seconds(); }
    /// Whether a piece of work fits that will take about so long.
    [[nodiscard]] bool fits(double seconds) const { return seconds <= leftS(); }

private:
    double seconds_;
    Stopwatch watch_;
};

/// Pieces of work that take about equally long, of which as many are done as an allowance has room for, but
/// no fewer than `least`.
class Rationed {
public:
    Rationed(const Allowance& allowance, std::size_t least) : allowance_(allowance), least_(least) {}

    /// Call before each piece: whether there is time for it.
    [[nodiscard]] bool next() {
        const double now = watch_.seconds(), last = now - begun_;
        begun_ = now;
        return done_++ < least_ || allowance_.fits(last);
    }

private:
    const Allowance& allowance_;
    std::size_t least_;
    Stopwatch watch_;
    double begun_ = 0;
    std::size_t done_ = 0;
};

/// Which of some pieces of work fit into `seconds` together, the cheapest first. `costs` in seconds.
inline std::vector<bool> affordable(const std::vector<double>& costs, double seconds) {
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
