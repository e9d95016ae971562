#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/geo/grid.h"

namespace noonmark {

/// What a computation cost and what it did not need to do. Part of every result.
struct Cost {
    std::map<std::string, double> seconds;         ///< by stage ("build", "trace"); stages do not overlap
    std::uint64_t rays = 0;                        ///< occlusion tests made, where the engine makes any
    std::uint32_t buildingsUsed = 0;               ///< buildings whose shadow can reach a receiver
    std::map<std::string, std::uint64_t> skipped;  ///< what was left undone, by reason in words
};

/// Shadow over a grid for one period. Cells that are no receivers hold NaN.
struct ShadowField {
    Grid grid;
    std::vector<float> grossMin;       ///< minutes in shadow a day, mean over the period's days; grid order
    std::vector<float> continuousMin;  ///< longest unbroken run on any day, minutes; grid order
    double sunlitMinutesPerDay = 0;  ///< mean minutes a day with the sun above the horizon: 100 % of the time
    double stepMinutes = 1;
    int days = 1;

    std::string engine;     ///< name and settings in words, for the report
    std::string engineKey;  ///< of the engine that made it ("ray"); engines that only choose another set it
    Warnings warnings;
    Cost cost;
};

}  // namespace noonmark
