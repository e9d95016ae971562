#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace noonmark::bench {

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
