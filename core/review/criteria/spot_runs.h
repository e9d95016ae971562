#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "core/measures/places/place_cells.h"
#include "core/review/criteria/verdict.h"
#include "core/review/rule/rule.h"

namespace noonmark {

/// The runs of one spot in one day, in steps.
struct RunCounts {
    std::uint32_t total = 0;        ///< of all runs
    std::uint32_t longest = 0;      ///< the longest run
    std::uint32_t longestRuns = 0;  ///< the sum of the longest runs asked for
    std::uint32_t count = 0;        ///< number of runs
};

/// The length of a step, and how uncertain that of a run is.
struct RunError {
    double stepMin = 1;
    double runErrorMin = 1;  ///< minutes; of n runs n times as much
};

/// How many longest runs are summed: a criterion's own number, or the parts of a broken total.
int runsWanted(const Criterion& criterion);

/// Counts runs by their lengths in steps; those shorter than the criterion's `dropShorterMin` are left out.
RunCounts countRuns(const Criterion& criterion, std::span<const std::uint32_t> lengths, double stepMin);

/// The minutes of a criterion about the worst spot (Measure::spotTotal and the like), for the runs of that
/// spot.
Measured measureSpot(const Criterion& criterion, const RunCounts& runs, const RunError& error);

/// Whether a spot has what the condition asks for, with the length of its runs changed by `sign` times their
/// error. Of a broken total with a number of parts the longest parts count, whatever other sun follows.
bool meets(const SpotCondition& spot, const RunCounts& runs, const RunError& error, int sign);

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
/// the slots of two steps ends a run. O(cells x steps / 64 + runs); words without the quantity cost no more
/// than reading them.
SpotRuns countRuns(const PlaceShadow& shadow, Quantity quantity, bool former,
                   const RunSettings& settings = {});

/// The runs of one day's spots, counted when first asked for and kept. Refers to the shadow.
class RunsOfDay {
public:
    explicit RunsOfDay(const PlaceShadow& shadow) : shadow_(&shadow) {}

    [[nodiscard]] const PlaceShadow& shadow() const { return *shadow_; }
    /// As countRuns(); valid as long as this.
    const SpotRuns& count(Quantity quantity, bool former, const RunSettings& settings = {});

private:
    struct Counted {
        Quantity quantity;
        bool former;
        RunSettings settings;
        SpotRuns runs;
    };
    const PlaceShadow* shadow_;
    std::deque<Counted> counted_;
};

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
