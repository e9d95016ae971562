#pragma once

#include <nlohmann/json.hpp>

#include "core/measures/statistics.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// The figures that studyJson(), impactJson() and scoreJson() wrote. Throw nlohmann's exceptions, or
/// std::invalid_argument, where the JSON is of another shape.
ShadowStatistics parseStatistics(const nlohmann::ordered_json& study);
ComparisonFigures parseComparison(const nlohmann::ordered_json& impact);
Score parseScore(const nlohmann::ordered_json& score);  ///< without grid, cells and warnings

/// The study's error against the ray reference in one line, or why it has none; empty where nothing is said.
std::string parseErrorWords(const nlohmann::ordered_json& study);

}  // namespace noonmark
