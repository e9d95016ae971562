#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/geo/grid.h"

namespace noonmark {

/// The cost of a computation and the work it could skip. Part of every result.
struct Cost {
    std::map<std::string, double> seconds;         ///< by stage ("build", "trace"); stages do not overlap
    std::uint64_t rays = 0;                        ///< occlusion tests, for engines that trace rays
    std::uint32_t buildingsUsed = 0;               ///< buildings whose shadow can reach a receiver
    std::map<std::string, std::uint64_t> skipped;  ///< skipped work by reason, in words
};

struct TreeShade;  // tree_shade.h

/// Shadow on a grid for one period. Cells that are not receivers hold NaN.
struct ShadowField {
    Grid grid;
    std::vector<float> grossMin;       ///< minutes in shadow per day, mean over the period's days; grid order
    std::vector<float> continuousMin;  ///< longest unbroken run on any day, minutes; grid order
    double sunlitMinutesPerDay = 0;    ///< mean minutes per day with the sun up; 100 % of the time
    double stepMinutes = 1;
    int days = 1;

    std::string engine;     ///< name and settings in words, for the report
    std::string engineKey;  ///< key of the engine that computed the field ("ray"); set by engines that
                            ///< delegate to another one
    Warnings warnings;
    Cost cost;
    std::shared_ptr<const TreeShade> trees;  ///< the same with trees; null: none reaches a receiver
};

}  // namespace noonmark
