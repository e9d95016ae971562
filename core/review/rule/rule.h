#pragma once

// The folder core/review evaluates the rules of review boards. Rule (this file) is a rule as data, read from
// JSON by read_rule.h; rule_library.h lists those that ship and those of the user's folders; docs/rules.md
// documents the fields. rule_days.h turns a rule's days, window and clock into SunSteps. place_review.h takes
// the shadow on a place day after day and reduces it to rows, figures and a verdict: spot_runs.h counts the
// runs of each cell, criterion_days.h a criterion over the days, verdict.h compares with a limit.
// glazing_rule.h is what a rule says about windows; glazing_review.h evaluates them one by one, and
// building_review.h by building.

#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/receivers/parcels/parcel_lines.h"
#include "core/receivers/place.h"
#include "core/review/rule/glazing_rule.h"
#include "core/sun/day_clock.h"
#include "core/sun/sun_paths.h"

namespace noonmark {

/// How days are combined to one value of a criterion.
enum class DayCombination {
    every,    ///< the limit must hold on every day: the worst day counts
    average,  ///< the mean over the days counts
    chosen,   ///< the limit must hold on one day of the user's choice: the best day counts
    sum,      ///< the sum over the days counts, each weighted by the days that it stands for
};

struct RuleDay {
    std::chrono::month_day day;
    std::vector<std::chrono::month_day>
        sameAs;  ///< days with nearly the same sun, for the reader's information
    std::string label;
    Evidence evidence;
};

/// Fixed days, or a range of days in each year; it may span New Year.
struct RuleDays {
    std::vector<RuleDay> fixed;              ///< in the order of the file; empty with a range
    std::chrono::month_day first{}, last{};  ///< inclusive; of a range
    int everyDays = 1;                       ///< of a range: 1 every day, 7 one day in seven; 1 to 31
    bool mirrored = false;  ///< days from 21 June on stand for those with the same distance before it
    DayCombination combination = DayCombination::every;
    std::optional<int> year;  ///< none: the user's
    Evidence evidence;
};

struct HoursBound {
    enum class Kind { clock, sunrise, sunset };
    Kind kind = Kind::clock;
    double minutes = 0;  ///< since midnight, 0 to 1440; or after sunrise or sunset, -720 to 720
    bool operator==(const HoursBound&) const = default;
};

/// The hours of a day: from the latest of `from` to the earliest of `to`.
struct HoursOfDay {
    std::vector<HoursBound> from, to;  ///< at least one each
    bool operator==(const HoursOfDay&) const = default;
};

struct CountedHours {
    HoursOfDay hours;
    std::map<std::chrono::month_day, HoursOfDay> byDay;  ///< days with hours of their own
    SunriseRule sunrise = SunriseRule::upperLimb;
    double minSunDeg = 0;  ///< the sun counts above this altitude only
    Evidence evidence;
};

struct RuleClock {
    ClockSettings settings;
    Evidence evidence;
};

struct RuleSampling {
    double stepMinutes = 1;  ///< 1/60 to 240
    int roundTo = 0;  ///< 60: steps begin on full hours of the clock, 30: on full and half hours, 0: anywhere
    Evidence evidence;
};

enum class RuleSurface { ground, plane, windows };

struct RuleReceivers {
    RuleSurface surface = RuleSurface::ground;
    double planeM = 0;               ///< of `plane`: metres above the mean ground, 0 to 1000
    std::vector<PlaceKind> kinds;    ///< kinds of places that the rule covers; empty: all
    double innerLineM = 0;           ///< lines at this distance from the parcel's line, 0 to 1000;
    double outerLineM = 0;           ///< 0: the rule has no lines
    std::optional<RoadShift> roads;  ///< of the parcel's line
    RuleGlazing glazing;             ///< of `windows`
    Evidence evidence;
    [[nodiscard]] bool hasLines() const { return outerLineM > 0; }
};

enum class RuleCasters {
    everything,  ///< all buildings of baseline and scenario
    proposal,    ///< only the buildings that the scenario adds or changes
};

/// The trees whose shade counts.
enum class RuleTrees {
    without,                ///< none
    evergreens,             ///< those that keep their leaves; all others are left out
    evergreenBelts,         ///< dense belts of those (findEvergreenBelts())
    asEvergreens,           ///< every tree, in leaf all year
    seasonal,               ///< every tree, by its season
    existingAndEvergreens,  ///< those of the baseline, by their season, and evergreens that the scenario adds
};

struct RuleOccluders {
    RuleCasters casters = RuleCasters::everything;
    bool terrain = true;
    RuleTrees trees = RuleTrees::without;
    Evidence treesEvidence;
    Evidence evidence;
};

enum class BaselineKind {
    existing,       ///< the city as it is
    noAction,       ///< a scenario with what would be built without the proposal
    referenceBody,  ///< a scenario with the body that the zoning allows
};

struct RuleBaseline {
    BaselineKind kind = BaselineKind::existing;
    Evidence evidence;
};

/// What is counted. A former quantity is the same one in the baseline.
enum class Quantity {
    shadow,       ///< shadow in the scenario, total
    incremental,  ///< shadow on what is lit in the baseline
    sun,          ///< sun in the scenario, within the rule's window
};

enum class Measure {
    spotTotal,        ///< minutes at the worst spot
    spotLongestRun,   ///< longest unbroken minutes at the worst spot
    spotLongestRuns,  ///< the sum of the `runs` longest unbroken runs at the worst spot, min
    areaOver,         ///< area whose spots have more minutes than `spot`, and more than in the baseline, m2
    share,            ///< share of the place whose spots meet `spot`, 0 to 1
    anywhere,         ///< minutes in which any spot of the place has it
    span,             ///< from its first to its last minute anywhere on the place, min
    fullCover,        ///< minutes in which all sun that the baseline leaves is gone
    largestArea,      ///< largest area at one moment, m2
    largestShare,     ///< the same as a share of the place, 0 to 1
    areaHours,        ///< area x hours, m2 h
    skyComponent,     ///< of a window: vertical sky component, percent
    probableSun,      ///< of a window: share of the year's probable sunlight hours, percent
};

/// What a spot needs so that it counts in Measure::share; of Measure::areaOver only the minutes. A window is
/// one spot: its share is 1 or 0.
struct SpotCondition {
    bool unbroken = false;     ///< the longest run counts, else the total
    double minutes = 0;        ///< at least
    double brokenMinutes = 0;  ///< or at least this in total, if broken up; 0: no such alternative
    double partMinutes = 0;    ///< of a broken total: the longest part has at least this
    int maxParts = 0;          ///< of a broken total: its longest parts, so many; 0: all of them; 0 to 8
};

enum class Comparison { atMost, below, atLeast, above };

/// One comparison with a limit. With `ofFormer` the ratio to the baseline's value is compared, with `isLoss`
/// besides what the baseline has more, in the unit of the measure.
struct Limit {
    Comparison comparison = Comparison::atMost;
    double value = 0;
    bool ofFormer = false;
    bool isLoss = false;  ///< only with ofFormer
    Evidence evidence;
};

/// Which part of the surroundings of a parcel a criterion is about.
enum class LineBelt { none, betweenLines, beyondLines };

/// One demand of a rule. It holds if one of its limits holds; without a limit its value is only stated.
struct Criterion {
    std::string key, name;
    Quantity quantity = Quantity::incremental;
    Measure measure = Measure::spotTotal;
    int runs = 1;                               ///< of spotLongestRuns, 1 to 8
    double dropShorterMin = 0;                  ///< runs shorter than this do not count, 0 to 600
    SpotCondition spot;                         ///< of share
    std::vector<Limit> limits;                  ///< any one must hold
    bool advisory = false;                      ///< stated, but does not decide the verdict
    std::optional<DayCombination> combination;  ///< none: that of the rule's days
    std::optional<std::pair<std::chrono::month_day, std::chrono::month_day>> season;  ///< days that count
    LineBelt belt = LineBelt::none;
    std::optional<FacingRange> facing;  ///< windows that it is about; none: all
    /// For windows: the sun counts between these times of the rule's clock only, minutes since midnight.
    std::optional<std::pair<double, double>> hours;
    Evidence evidence;
};

/// A column of the rule's own table: a key of review rows (docs/rules.md) under the rule's title.
struct RuleColumn {
    std::string title, key;
};

struct RuleDiagrams {
    std::vector<double> timesMin;  ///< minutes since midnight of the rule's clock
    std::map<std::chrono::month_day, std::vector<double>> byDay;
    std::vector<std::string> views;  ///< "plan", "fan", "isochrones", "elevation", "view from the sun"
    Evidence evidence;
};

struct Deliverables {
    std::vector<RuleColumn> columns;
    Evidence columnsEvidence;
    std::optional<RuleDiagrams> diagrams;
    std::string scale;               ///< empty: none asked for
    std::vector<std::string> stamp;  ///< what must be on the sheet
};

/// A figure that is stated with the rule, but not computed with.
struct StatedFigure {
    std::string text;
    Evidence evidence;
};

/// A city or a part of a country: a circle on the earth.
struct RuleArea {
    LonLat centre;
    double radiusM = 0;
};

/// A rule of a review board. Complete and checked: made by parseRule().
struct Rule {
    std::string key;  ///< a to z, 0 to 9 and hyphens
    std::string name, where, summary, source;
    std::vector<std::string> countries;  ///< ISO 3166-1 codes where it applies; empty: anywhere
    std::optional<RuleArea> area;        ///< the part of the country where it applies; none: all of it
    bool isSouthern = false;             ///< its dates are seasons of the southern half of the earth
    RuleDays days;
    CountedHours window;
    RuleClock clock;
    RuleSampling sampling;
    RuleReceivers receivers;
    RuleOccluders occluders;
    RuleBaseline baseline;
    std::vector<Criterion> criteria;
    /// For windows: the rule holds if all criteria of one of these lists hold. Empty: all must hold.
    std::vector<std::vector<std::string>> alternatives;
    std::vector<UnitShare> shares;          ///< of windows: what a building needs; empty: each window decides
    std::optional<SunshineTable> sunshine;  ///< of Measure::probableSun; none: every hour of sun counts
    std::optional<double> theoreticalHours;  ///< yearly sun that shares refer to; none: counted
    Evidence theoreticalEvidence;
    Deliverables deliverables;
    std::vector<StatedFigure> figures;
    std::vector<std::string> readings;          ///< how Noonmark reads what the rule leaves open
    std::vector<std::string> notChecked;        ///< what the rule asks for and Noonmark does not evaluate
    std::map<std::string, std::string> chosen;  ///< choice -> option, as this rule was read
    std::map<std::string, std::vector<std::string>> choices;  ///< choice -> its options
    std::string file;                                         ///< empty: shipped with Noonmark
};

}  // namespace noonmark
