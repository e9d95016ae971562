#pragma once

#include <nlohmann/json_fwd.hpp>
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

/// The command line that repeats it; see core/study/provenance/repeat_command.h.
Result<std::string> makeRepeatCommand(const ScoreAnswer& answer, std::size_t width = 120);

/// An object for each month: month, and its figures.
nlohmann::ordered_json monthsJson(const std::vector<MonthFigures>& months);

/// Stable keys with their units; lists months, and intervals with their weights.
std::string scoreJson(const ScoreAnswer& answer);

/// A heading and one line per month: month, sunlit minutes, weighted shade, shadow area, score.
std::string scoreCsv(const ScoreAnswer& answer);

}  // namespace noonmark
