#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/city/city.h"
#include "core/study/point_cases.h"

namespace noonmark {

/// One sentence: "The proposal takes 41 min a day from this point between 9 November and 2 February, mostly
/// 13:10-14:05.", or without a scenario when the point is lit on the day and what hides most of its skyline.
std::string describe(const PointStudy& study, const City& city);

/// The answer of `noonmark-cli point` (docs/user/command-line.md). `city`: the baseline; `scenario`: the city
/// of the scenario, where the study has one. They name buildings.
nlohmann::ordered_json pointJson(const PointStudy& study, const City& city, const City* scenario,
                                 const Zone& zone);

/// `scenarios` of `noonmark-cli point --all-scenarios`. `wall`: the vertical sky component is known.
nlohmann::ordered_json pointCasesJson(const std::vector<PointCaseFigures>& cases, bool wall);

/// Sunlit times of the day on the clock: "09:46-10:41, 12:06-14:15", or "not at all".
std::string sunlitText(const std::vector<SunBand>& sunlit, const Zone& zone);

/// The sun that crowns leave: "212 min on the day and 1,240 h in the year with their seasons, ...".
std::string treesText(const PointCrowns& crowns);
/// The trees that take most of the sun that buildings leave, with their seasons: "Tilia cordata (tree 3) 42
/// min on the day, 210 h in the year; 4 more"; empty: none takes any.
std::string takenText(const PointCrowns& crowns);
/// The sky that trees leave: "sky view factor 0.331 with their seasons, 0.290 as evergreens".
std::string treesSkyText(const PointCrowns& crowns, bool wall);

/// What hides the sun on the day, and when: "One57 10:41-12:06, the terrain 14:15-14:30", or "nothing".
std::string shadedText(const PointView& view, const City& city, const Zone& zone);

/// Sunlit minutes of the year: a line for each month and hour of the wall clock, with the scenario's in a
/// column of their own; with trees in further ones ("baseline_min_seasonal").
std::string pointCsv(const PointStudy& study);

/// How many degrees of the skyline each building makes (index in City::buildings); of a wall, in front of it
/// only.
std::map<std::uint32_t, double> skylineWidthsDeg(const PointView& view,
                                                 const std::optional<double>& facingDeg);

/// The name of a building or its id; "the terrain", "the wall itself".
std::string nameOfObstacle(const City& city, std::uint32_t building);

}  // namespace noonmark
