#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/review/criteria/criterion_days.h"
#include "core/sun/day_clock.h"

namespace noonmark {

/// What is measured of one place on one day. Times are those of the rule's clock; "incremental" shadow lies
/// on what is lit in the baseline.
struct ReviewRow {
    CivilDate day;
    double weight = 1;                     ///< days of the year that it stands for
    std::optional<Instant> enters, exits;  ///< of incremental shadow: first step, end of the last one
    std::string entersText, exitsText;     ///< "08:51" in the rule's clock; empty without incremental shadow
    double durationMin = 0;                ///< minutes with incremental shadow anywhere on the place
    int intervals = 0;                     ///< unbroken intervals of them
    double maxAreaM2 = 0, maxShare = 0;    ///< largest incremental shadow at one step
    std::string maxAtText;                 ///< when; empty without
    double maxPointMin = 0;                ///< most minutes of incremental shadow at one spot
    double maxPointRunMin = 0;             ///< longest unbroken incremental shadow at one spot
    double fullCoverMin = 0;               ///< minutes in which all sun that the baseline leaves is gone
    double totalDurationMin = 0, totalMaxAreaM2 = 0, totalMaxPointMin = 0;  ///< of all shadow
    double minSunMin = 0, minSunRunMin = 0;  ///< sun of the spot with least sun; its longest run
    int minSunIntervals = 0;                 ///< of that spot
    double minLongestSunMin = 0;             ///< the longest unbroken sun of the spot where it is shortest
    double baselineM2h = 0, scenarioM2h = 0, incrementalM2h = 0, gainedM2h = 0;
    double hoursMin = 0;                          ///< minutes with the sun up in the rule's hours
    std::vector<std::optional<double>> criteria;  ///< by criterion of the review; none: out of season
};

/// Sums over the rule's days, each weighted by the days that it stands for.
struct ReviewTotals {
    double days = 0, daysWithIncremental = 0;
    double sunHours = 0;        ///< hours with the sun up in the rule's hours
    double theoreticalM2h = 0;  ///< area x the rule's own hours of a year, or else x sunHours
    double baselineM2h = 0, scenarioM2h = 0, incrementalM2h = 0, gainedM2h = 0;
    std::array<double, 12> incrementalByMonthM2h{};
    std::optional<CivilDate> largestDay;  ///< the day with most incremental area x hours; first of equals
    double largestDayM2h = 0, largestDayDurationMin = 0;
};

/// A rule's answer for one place.
struct PlaceReview {
    std::string name;
    PlaceKind kind = PlaceKind::other;
    LineBelt belt = LineBelt::none;
    double areaM2 = 0;  ///< of the cells that are receivers
    Verdict verdict = Verdict::notChecked;
    std::optional<std::size_t> deciding;   ///< the criterion whose result is the verdict
    std::string reasonNotJudged;           ///< why none decides; a sentence without a full stop
    std::vector<Criterion> criteria;       ///< those of the rule that apply to this place
    std::vector<CriterionResult> results;  ///< by criterion
    std::vector<ReviewRow> rows;           ///< in the order of the days
    ReviewTotals totals;
};

/// Evaluates a rule on one place from a stream of days. Memory does not grow with the length of a day. The
/// rule and the clock must outlive it.
class PlaceEvaluation {
public:
    /// `engineErrorMin`: what the engine adds to the error of the length of a run; 0 for exact engines.
    PlaceEvaluation(const Rule& rule, const DayClock& clock, std::string name, PlaceKind kind,
                    double engineErrorMin = 0, LineBelt belt = LineBelt::none);

    /// `weight`: days of the year that the day stands for (RuleSun::weights). `spots`: as of DayShadow.
    void add(const PlaceShadow& shadow, double weight = 1, std::span<const PlaceShadow> spots = {});
    [[nodiscard]] PlaceReview finish() const;

private:
    void addTotals(const ReviewRow& row);
    void judge(PlaceReview& review) const;

    const Rule* rule_;
    const DayClock* clock_;
    double engineErrorMin_;
    PlaceReview review_;
    std::vector<CriterionDays> days_;
    bool sunWasUp_ = false;
};

/// Whether a rule covers places of that kind.
bool covers(const Rule& rule, PlaceKind kind);

}  // namespace noonmark
