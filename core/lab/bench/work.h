#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"

namespace noonmark::bench {

/// The time limit of an experiment, counted from construction. Necessary measurements are made in any case;
/// optional ones are left out if they do not fit, and the report states that.
class Allowance {
public:
    explicit Allowance(double seconds = std::numeric_limits<double>::infinity()) : seconds_(seconds) {}

    [[nodiscard]] double secondsLeft() const { return seconds_ - watch_.seconds(); }

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

/// Progress, stop token and time limit of an experiment.
struct Work {
    Progress& progress;
    std::stop_token stop;
    Allowance allowance{};

    [[nodiscard]] bool stopped() const { return stop.stop_requested(); }
};

/// Progress over a list of pieces of work that take about equally long.
class Pieces {
public:
    Pieces(const Work& work, std::string stage, std::size_t count)
        : work_(work), stage_(std::move(stage)), count_(count) {}

    /// Call before each piece.
    void next() { work_.progress.report(double(done_++) / double(count_), stage_); }

private:
    const Work& work_;
    std::string stage_;
    std::size_t count_;
    std::size_t done_ = 0;
};

/// How much is measured. `words` states everything that is left out compared with the full extent.
struct Extent {
    int sunTimes = 1000;  ///< random times of the year, for the linearity of the sun's path
    int hours = 60;       ///< random hours and positions, for errors (paper, section 7: "a set of")
    /// For the direction graph's errors: random hours, assigned to the positions in turn, and receivers at
    /// each position.
    int graphHours = 60, graphPositions = 10;
    std::size_t graphReceivers = std::numeric_limits<std::size_t>::max();
    int positions = 10;    ///< positions for the comparison of all engines
    int days = 20;         ///< days at each position
    double hoursADay = 6;  ///< from 9:00 on, around noon, for the comparison of all engines
    std::vector<int> resolutions{256, 512, 800, 1024, 1600, 2048};
    std::vector<int> dayCounts{1, 2, 5, 10, 30, 90, 180, 365};
    /// Bin widths for the error curve of the horizon sweep
    std::vector<double> binsDeg{0.125, 0.25, 0.5, 0.7, 1, 2};
    /// Every option of an engine is tried at these multiples of its default.
    std::vector<double> factors{0.25, 0.5, 1, 2, 4};
    /// Times are medians of this many runs; all contestants of a comparison run in turn.
    int runs = 5;
    /// A contestant whose first run takes longer is not run again; that run counts. Seconds.
    double onceAboveS = std::numeric_limits<double>::infinity();
    /// A contestant that is predicted to take longer is left out, or extrapolated from a shorter period.
    /// Seconds.
    double neverAboveS = std::numeric_limits<double>::infinity();
    /// Time budget of all experiments together: optional measurements that would exceed it are left out.
    /// Seconds.
    double budgetS = std::numeric_limits<double>::infinity();
    std::size_t sampleReceivers = 3000;  ///< size of the sample for the truth over months and years
    std::string words = "Full extent.";
};

/// Takes some hours on two cores.
Extent makeFullExtent();

/// Takes at most 5 minutes on two cores.
Extent makeQuickExtent();

}  // namespace noonmark::bench
