#pragma once

#include <array>
#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/review/rule/rule.h"

namespace noonmark {

/// The names of an enumeration in rule files and outputs.
template <class E>
using RuleNames = std::span<const std::pair<E, std::string_view>>;

RuleNames<FigureStatus> figureStatusNames();   ///< "V", "R", "U"
RuleNames<DayCombination> combinationNames();  ///< "every", "average", "chosen", "sum"
RuleNames<ClockKind> clockNames();             ///< "civil", "standard", "fixed", "true solar"
RuleNames<SunriseRule> sunriseNames();         ///< "upper limb", "centre"
RuleNames<RuleSurface> surfaceNames();         ///< "ground", "plane", "windows"
RuleNames<RuleCasters> casterNames();          ///< "everything", "proposal"
RuleNames<RuleTrees> ruleTreesNames();         ///< "without", "evergreens", "evergreen belts", ...
RuleNames<BaselineKind> baselineNames();       ///< "existing", "no action", "reference body"
RuleNames<Quantity> quantityNames();           ///< "shadow", "incremental", "sun"
RuleNames<Measure> measureNames();             ///< "spot total", "share", ...
RuleNames<Comparison> comparisonNames();       ///< "<=", "<", ">=", ">"
RuleNames<LineBelt> beltNames();               ///< "between lines", "beyond lines"
RuleNames<PanePlace> panePlaceNames();         ///< "mid pane", "sill middle", "sill ends"
RuleNames<bool> faceNames();                   ///< "outside", "inside": whether it is the inside face
RuleNames<GlazingUnit> unitNames();            ///< "window", "room", "dwelling"

template <class E>
std::string_view ruleNameOf(RuleNames<E> names, E value) {
    for (const auto& [candidate, name] : names)
        if (candidate == value) return name;
    return {};
}

/// "read in the rule's text", "reported by practice", "not checked against the rule's text"
std::string_view meaningOf(FigureStatus status);

/// "evergreen trees only": the column of figures with trees that a rule counts.
std::string_view describe(RuleTrees counted);

/// "min", "m2", "m2 h", "%" of windows' measures, or nothing for shares.
std::string_view unitOf(Measure measure);

// Days and times as rule files write them. Nothing: the text is none of these.

std::optional<std::chrono::month_day> parseRuleDay(std::string_view text);  ///< "03-21"; "02-29" is a day
std::optional<double> parseRuleTime(std::string_view text);  ///< "09:18": minutes; up to "24:00"
/// "09:18", "sunrise+1.5h", "sunset-90m", "sunrise"; at most 12 h from sunrise or sunset.
std::optional<HoursBound> parseHoursBound(std::string_view text);

std::string formatText(std::chrono::month_day day);  ///< "03-21"
std::string formatRuleTime(double minutes);          ///< "09:18"
std::string formatText(const HoursBound& bound);     ///< "sunrise+1.5h"
/// "the latest of 08:00, sunrise+1h to sunset-1h"
std::string formatText(const HoursOfDay& hours);

}  // namespace noonmark
