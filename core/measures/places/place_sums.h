#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "core/describe/figure.h"
#include "core/engines/api/tree_shade.h"
#include "core/measures/places/place_cells.h"
#include "core/measures/places/place_timeline.h"

namespace noonmark {

/// Numbers of a place's cells at one step.
struct StepCounts {
    std::size_t baseline = 0;     ///< in shadow in the baseline
    std::size_t scenario = 0;     ///< in shadow in the scenario
    std::size_t incremental = 0;  ///< in shadow in the scenario alone
    bool operator==(const StepCounts&) const = default;
};

/// Counts the bits of two masks of equal size. Backend: step_counts_hwy.cpp. Cost: 0.2 ns a word of 64 cells
/// with AVX2.
StepCounts countStep(std::span<const std::uint64_t> baseline, std::span<const std::uint64_t> scenario);

/// Areas of a place at one step, m2, each cell by its share.
struct StepAreas {
    double baselineM2 = 0;     ///< in shadow in the baseline
    double scenarioM2 = 0;     ///< in shadow in the scenario
    double incrementalM2 = 0;  ///< in shadow in the scenario alone
    double gainedM2 = 0;       ///< in shadow in the baseline alone
    StepCounts centres;        ///< cells whose centre lies in the place
    [[nodiscard]] std::size_t gainedCentres() const {
        return centres.baseline + centres.incremental - centres.scenario;
    }
};

/// Number of cells whose centre lies in the place.
std::size_t countCentres(const PlaceShadow& shadow);

/// The masks with those cells all lit whose centre lies outside the place: edge cells count as lit.
StepMasks dropEdgeCells(const PlaceShadow& shadow, const StepMasks& masks);

/// `counts` of the same step (countStep()). O(uneven cells).
StepAreas weighStep(const PlaceShadow& shadow, std::size_t step, const StepCounts& counts);

/// The 64 bits from `bit` on; 0 beyond the last word.
std::uint64_t bitsAt(std::span<const std::uint64_t> words, std::size_t bit);

/// Between how many neighbouring cells a mask changes: its edge passes through half of their area at most,
/// which bounds what cells add to its true area or take from it, unless it is narrower than a cell.
std::size_t countEdges(std::span<const std::uint64_t> words, std::span<const NeighbourCells> neighbours);

/// Shadow on a place over some days, in m2 x h.
struct AreaHours {
    int days = 0;
    double sunlitHours = 0;
    double theoreticalM2h = 0;  ///< area x sunlit hours: what the place would have without any shadow
    double baselineM2h = 0;
    double scenarioM2h = 0;
    double incrementalM2h = 0;
    double gainedM2h = 0;

    void add(const DayTimeline& day);
    /// The share of the theoretical sum, 0 to 1; 0 without sun.
    [[nodiscard]] double shareOf(double m2h) const { return theoreticalM2h > 0 ? m2h / theoreticalM2h : 0; }
    bool operator==(const AreaHours&) const = default;
};

/// The day on which a place has the most of one kind of shadow, in area x hours.
struct MaxShadowDay {
    CivilDate day;
    double areaHoursM2 = 0;
};

/// Quarters of a year by the days on which planners measure: from 21 March, 21 June, 21 September and 21
/// December on.
enum class Quarter { fromMarch, fromJune, fromSeptember, fromDecember };
inline constexpr std::array quarterNames{"21 Mar to 20 Jun", "21 Jun to 20 Sep", "21 Sep to 20 Dec",
                                         "21 Dec to 20 Mar"};
Quarter quarterOf(CivilDate day);

/// Sums of a period, day by day.
class PlaceSums {
public:
    void add(const DayTimeline& day);

    [[nodiscard]] const AreaHours& all() const { return all_; }
    [[nodiscard]] const std::array<AreaHours, 4>& quarters() const { return quarters_; }
    /// "2026-01", "2026-02", ...
    [[nodiscard]] const std::map<std::string, AreaHours>& months() const { return months_; }
    /// The first day with most scenario shadow, and with most incremental shadow; none without any.
    [[nodiscard]] const std::optional<MaxShadowDay>& maxScenarioDay() const { return maxScenarioDay_; }
    [[nodiscard]] const std::optional<MaxShadowDay>& maxIncrementalDay() const { return maxIncrementalDay_; }
    /// The largest incremental area at one step of any day, and when.
    [[nodiscard]] double largestIncrementalM2() const { return largestM2_; }
    [[nodiscard]] const std::optional<Instant>& largestIncrementalAt() const { return largestAt_; }

private:
    AreaHours all_;
    std::array<AreaHours, 4> quarters_;
    std::map<std::string, AreaHours> months_;
    std::optional<MaxShadowDay> maxScenarioDay_, maxIncrementalDay_;
    double largestM2_ = 0;
    std::optional<Instant> largestAt_;
};

/// The areas of a place at one step, without its time.
const Figures<PlaceStep>& placeStepFigures();

const Figures<AreaHours>& areaHoursFigures();

/// The same with trees: "baseline_m2_evergreen", "scenario_m2h_seasonal".
std::span<const Figure> placeStepFiguresWithTrees(TreeColumns column);
std::span<const Figure> areaHoursFiguresWithTrees(TreeColumns column);

}  // namespace noonmark
