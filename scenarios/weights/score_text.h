#pragma once

#include <string>

#include "scenarios/weights/score.h"

namespace noonmark {

/// A score with the question that it answers.
struct ScoreAnswer {
    std::string scenario;
    StudySettings settings;
    TimeWeights weights;
    Score score;
    Provenance provenance{};
};

/// The command that repeats it; see core/study/provenance/repeat_command.h.
Result<std::string> repeatCommand(const ScoreAnswer& answer, std::size_t width = 120);

/// Keys are stable, units in their names; the months and the intervals with their weights.
std::string scoreJson(const ScoreAnswer& answer);

/// One line a month: year, month, sunlit minutes, shadow area, score; with a heading.
std::string scoreCsv(const ScoreAnswer& answer);

}  // namespace noonmark
