#pragma once

#include <string>

#include "scenarios/weights/score.h"

namespace noonmark {

/// A score with its settings.
struct ScoreAnswer {
    std::string scenario;
    StudySettings settings;
    TimeWeights weights;
    Score score;
    Provenance provenance{};
};

/// What its figures mean, as files and sheets state it.
inline constexpr const char* weightedShadeDefinition =
    "sum over the steps of weight x hours in shadow x cell area, m2 h over the period; how the weight table "
    "is cut "
    "into intervals does not change it";
inline constexpr const char* scoreDefinition =
    "sum over the intervals of the weight table of weight x share of the interval's sunlit time in shadow, "
    "times cell "
    "area; an interval that is cut in two counts twice";

/// The command line that repeats it; see core/study/provenance/repeat_command.h.
Result<std::string> makeRepeatCommand(const ScoreAnswer& answer, std::size_t width = 120);

/// Stable keys with their units; lists months, and intervals with their weights.
std::string scoreJson(const ScoreAnswer& answer);

/// A heading and one line per month: month, sunlit minutes, weighted shade, shadow area, score.
std::string scoreCsv(const ScoreAnswer& answer);

}  // namespace noonmark
