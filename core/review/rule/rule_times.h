#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "core/review/rule/rule.h"

namespace noonmark {

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
