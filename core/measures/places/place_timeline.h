#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/measures/places/place_cells.h"

namespace noonmark {

/// A row of bits, one row a step: bit c of each row belongs to the same receiver. The bits are those of
/// `set` that are not in `unset`.
struct BitRow {
    const std::uint64_t* set = nullptr;    ///< null: no bit is set
    const std::uint64_t* unset = nullptr;  ///< null: none
};

/// A run of set bits of one column.
struct ColumnRun {
    std::size_t row = 0;  ///< the first
    std::size_t column = 0;
    std::size_t length = 0;  ///< in rows
};

/// The longest unbroken run of set bits in any column: the earliest, and of these the first column; none
/// where no bit is set. Each row has `words` words. O(bits / 64 x log length) at most; columns without a run
/// as long as one that is known cost less.
std::optional<ColumnRun> findLongestColumnRun(std::span<const BitRow> rows, std::size_t words);

/// The areas of a place in shadow at one step, m2.
struct PlaceStep {
    Instant at;  ///< the beginning of the step
    double baselineM2 = 0;
    double scenarioM2 = 0;
    double incrementalM2 = 0;  ///< in shadow in the scenario, lit in the baseline
    double gainedM2 = 0;       ///< lit in the scenario, in shadow in the baseline
};

/// An unbroken time, from the beginning of its first step to the end of its last.
struct TimeSpan {
    Instant from, to;
    [[nodiscard]] double minutes() const {
        return std::chrono::duration<double, std::ratio<60>>(to - from).count();
    }
    bool operator==(const TimeSpan&) const = default;
};

/// The longest unbroken shadow at the centre of one cell.
struct LongestStay {
    double minutes = 0;  ///< steps x step length
    /// How much longer it may last elsewhere in that cell: the most that lies between its stay and the
    /// longest of the cells beside it, and a step.
    double errorMin = 0;
    std::size_t cell = 0;  ///< its bit in the place's masks; the first of several
    TimeSpan when;
};

/// One kind of shadow (baseline, scenario, incremental or gained) on a place over a day.
struct ShadowOnPlace {
    /// When any of the place is in shadow: none, or one span after the other. A time with the sun down, or
    /// outside the window, ends a span.
    std::vector<TimeSpan> intervals;
    double minutes = 0;  ///< of all intervals: steps with any shadow x step length
    double largestM2 = 0;
    std::optional<Instant> largestAt;  ///< the first step with that area
    std::optional<LongestStay> longest;
    double areaHoursM2 = 0;  ///< m2 x h

    /// The beginning of the first interval and the end of the last; none without shadow.
    [[nodiscard]] std::optional<Instant> enters() const;
    [[nodiscard]] std::optional<Instant> exits() const;
};

/// Everything about a place's shadow on one day that follows without a rule.
struct DayTimeline {
    CivilDate day;
    double areaM2 = 0;         ///< of the place's cells
    double sunlitMinutes = 0;  ///< steps x step length
    /// Length of a step. Each beginning and end of shadow is at most this much too late, as each step has the
    /// sun of its beginning.
    double stepMinutes = 1;
    std::vector<PlaceStep> steps;
    ShadowOnPlace baseline, scenario, incremental, gained;
    double fullCoverMin = 0;  ///< minutes in which the scenario shades the whole place
    /// Minutes in which some of the place is lit in the baseline and none in the scenario: the proposal takes
    /// all the sun that was left.
    double allSunTakenMin = 0;

    [[nodiscard]] double theoreticalM2h() const { return areaM2 * sunlitMinutes / 60; }
};

/// Which of its numbers are wanted; longest stays cost as much as all else together.
struct TimelineSettings {
    bool steps = true;
    bool longestStays = true;
    /// Points of the place between the centres of its cells, at the same steps: shadow on them counts for
    /// intervals and minutes, not for areas, full cover and stays.
    std::span<const PlaceShadow> spots{};
};

/// O(cells / 64 x steps), longest stays times the logarithm of their length: some 0.3 ms for a hectare at 1 m
/// and 720 steps.
DayTimeline computeTimeline(const PlaceShadow& shadow, const TimelineSettings& settings = {});

}  // namespace noonmark
