#pragma once

#include <cstdint>
#include <vector>

#include "core/measures/place_shadow.h"
#include "core/review/rule/rule.h"

namespace noonmark {

/// Which runs of a spot count.
struct RunSettings {
    int longest = 1;            ///< the sum of so many longest runs is wanted, 1 to 8
    double dropShorterMin = 0;  ///< runs shorter than this are left out of everything
    bool operator==(const RunSettings&) const = default;
};

/// The unbroken runs of every cell of a place in one day, in steps, by cell.
struct SpotRuns {
    std::vector<std::uint32_t> total;        ///< steps of all runs
    std::vector<std::uint32_t> longest;      ///< the longest run
    std::vector<std::uint32_t> longestRuns;  ///< the sum of the longest runs asked for
    std::vector<std::uint32_t> count;        ///< number of runs
};

/// Leaves cells whose centre lies beside the place out of a search for the worst spot: they get no shadow, or
/// sun without end.
void leaveOutBeside(const PlaceShadow& shadow, Quantity quantity, std::vector<std::uint32_t>& steps);

/// Counts the runs of a quantity; `former`: in the baseline (none of Quantity::incremental). A gap between
/// the slots of two steps ends a run. O(cells x steps / 64 + runs).
SpotRuns countRuns(const PlaceShadow& shadow, Quantity quantity, bool former,
                   const RunSettings& settings = {});

/// Whether each cell has the quantity at a step at which the baseline does not have it.
std::vector<bool> findSpotsWithMore(const PlaceShadow& shadow, Quantity quantity);

/// Cells in shadow at each step of the day, of those with their centre in the place; and areas, of all cells
/// by their shares.
struct ShadedCells {
    std::vector<std::uint32_t> baseline, scenario, incremental;
    std::vector<double> baselineM2, scenarioM2, incrementalM2;
};
ShadedCells countShadedCells(const PlaceShadow& shadow);

}  // namespace noonmark
