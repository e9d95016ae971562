#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/measures/places/place_sums.h"
#include "core/review/criteria/spot_runs.h"

namespace noonmark {

/// What one criterion found on one place.
struct CriterionResult {
    Verdict verdict = Verdict::notChecked;
    std::optional<Measured> value;   ///< of the deciding day, or of all days together; none: no day counted
    std::optional<Measured> former;  ///< the same in the baseline, where a limit compares with it
    std::optional<CivilDate> day;    ///< the day that decides; none for averages and sums
    int days = 0, failingDays = 0, borderlineDays = 0;
};

/// The rule as it judges a city without a proposal, in which each value is its former one: without limits
/// relative to the baseline. A criterion that has no other limit is stated only.
Rule dropComparisons(Rule rule);

/// A place's shadow on one day as its figures and criteria look at it: runs of each quantity are counted
/// once.
class DayShadow {
public:
    /// `spots`: points near the worst spots (refineWorstSpots()); they count for figures of single spots
    /// only, not for areas and shares. Without them the error of a worst spot includes its cell.
    DayShadow(const PlaceShadow& shadow, double engineErrorMin, std::span<const PlaceShadow> spots = {})
        : shadow_(shadow),
          spots_(spots),
          cells_(countShadedCells(shadow)),
          areaM2_(shadow.areaM2()),
          centres_(countCentres(shadow)),
          engineErrorMin_(engineErrorMin) {
        runs_.emplace_back(shadow);
        for (const PlaceShadow& near : spots) runs_.emplace_back(near);
    }

    [[nodiscard]] const PlaceShadow& shadow() const { return shadow_; }
    [[nodiscard]] std::span<const PlaceShadow> spots() const { return spots_; }
    /// Of the shadow, then of each of the spots. Counts when asked: not for two threads at once.
    [[nodiscard]] std::span<RunsOfDay> runs() const { return runs_; }
    [[nodiscard]] const ShadedCells& cells() const { return cells_; }
    [[nodiscard]] double areaM2() const { return areaM2_; }
    /// Number of cells whose centre lies in the place.
    [[nodiscard]] std::size_t centres() const { return centres_; }
    [[nodiscard]] double stepMin() const { return shadow_.stepMinutes; }
    /// Minutes of one step, and what the engine adds: the error of the length of one run.
    [[nodiscard]] double runErrorMin() const { return shadow_.stepMinutes + engineErrorMin_; }

private:
    const PlaceShadow& shadow_;
    std::span<const PlaceShadow> spots_;
    ShadedCells cells_;
    double areaM2_;
    std::size_t centres_;
    double engineErrorMin_;
    mutable std::vector<RunsOfDay> runs_;
};

/// The errors: each run is uncertain by a step and the engine's error, an area by half of the cells that its
/// edge passes through, at least by one, a share by these and by the spots whose minutes are within their
/// error of what they need. Area x hours are uncertain by the areas' errors and by half of what the area
/// changes from step to step.
Measured measureDay(const Criterion& criterion, const DayShadow& day, bool former);

/// Compares a value with the limits of a criterion, any one of which must hold. Not applicable: it has no
/// limit, or only limits relative to a former value that does not exist. `unchanged`: value and former come
/// from the same sun, so that their ratio is exactly 1.
Verdict judgeLimits(const Criterion& criterion, const Measured& value, const std::optional<Measured>& former,
                    bool unchanged = false);

/// Whether a criterion is about that day.
bool isInSeason(const Criterion& criterion, CivilDate date);

/// Combines the days of one criterion. Takes days in any order.
class CriterionDays {
public:
    CriterionDays(const Criterion& criterion, DayCombination standard)
        : criterion_(&criterion), combination_(criterion.combination.value_or(standard)) {}

    /// `weight`: days that this day stands for. Returns the day's value; none if the day is out of season.
    std::optional<double> add(const DayShadow& day, double weight);
    /// The same for a day in season whose value is known, and its former value where there is one.
    void add(CivilDate day, const Measured& value, const std::optional<Measured>& former, double weight,
             bool unchanged = false);
    [[nodiscard]] CriterionResult result() const;

private:
    void takeDay(CivilDate day, const Measured& value, const std::optional<Measured>& former, bool unchanged);
    [[nodiscard]] bool decidesOver(Verdict verdict, double value) const;

    const Criterion* criterion_;
    DayCombination combination_;
    CriterionResult found_;
    Measured sum_, formerSum_;
    double weights_ = 0, squaredErrors_ = 0;
    bool hasFormer_ = false, unchanged_ = true;
};

}  // namespace noonmark
