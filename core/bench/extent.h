#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace noonmark::bench {

/// How much is measured. Everything that is left out against the full extent is said in `words`.
struct Extent {
    int sunTimes = 1000;  ///< random times of the year, for the sun's own figures
    int hours = 60;       ///< random hours and positions, for errors (paper, section 7: "a set of")
    /// Of the direction graph's errors: random hours, dealt in turn to the positions, and receivers of each.
    int graphHours = 60, graphPositions = 10;
    std::size_t graphReceivers = std::numeric_limits<std::size_t>::max();
    int positions = 10;    ///< of the comparison of all engines
    int days = 20;         ///< of each position
    double hoursADay = 6;  ///< from 9:00 on, around noon, of the comparison of all engines
    std::vector<int> resolutions{256, 512, 800, 1024, 1600, 2048};
    std::vector<int> dayCounts{1, 2, 5, 10, 30, 90, 180, 365};
    std::vector<double> binsDeg{0.125, 0.25, 0.5, 0.7, 1, 2};  ///< of the horizon sweep's error curve
    /// Every option of an engine is tried at these multiples of its usual value.
    std::vector<double> factors{0.25, 0.5, 1, 2, 4};
    /// Times are medians of so many runs, all that are compared in turn.
    int runs = 5;
    /// What takes longer than this at first is not run again: its one run counts. Seconds.
    double onceAboveS = std::numeric_limits<double>::infinity();
    /// What is expected to take longer than this is left out, or worked out from a shorter period. Seconds.
    double neverAboveS = std::numeric_limits<double>::infinity();
    /// Of all experiments together: what one can do without is left out where it would take longer. Seconds.
    double budgetS = std::numeric_limits<double>::infinity();
    std::size_t sampleReceivers = 3000;  ///< for the truth over months and years
    std::string words = "Full extent.";
};

/// Some hours on two cores.
Extent makeFullExtent();

/// Within 5 minutes on two cores.
Extent makeQuickExtent();

}  // namespace noonmark::bench
