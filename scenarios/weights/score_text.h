#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "core/describe/answer_page.h"
#include "core/describe/figure.h"
#include "core/describe/figure_text.h"
#include "scenarios/weights/score.h"

namespace noonmark {

const Figures<ScoreTotals>& scoreFigures();
const Figures<MonthFigures>& scoreMonthFigures();        ///< of a month, without its name
const Figures<IntervalFigures>& scoreIntervalFigures();  ///< of an interval, without its name

/// The same with trees of a column: "score_m2_evergreen".
std::span<const Figure> scoreFiguresWithTrees(TreeColumns column);
std::span<const Figure> scoreMonthFiguresWithTrees(TreeColumns column);
std::span<const Figure> scoreIntervalFiguresWithTrees(TreeColumns column);

/// The totals for people: without trees, then with them.
std::vector<FigureLine> listScoreLines(const Score& score);

/// The page of a score, or of one of its columns: whether wanted shade outweighs unwanted shadow, and both by
/// month.
AnswerPage makePage(const ScoreTotals& score, std::span<const MonthFigures> months,
                    const std::string& scenario, ShownAs show = ShownAs::shadow);

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

/// An object for each month: month, and its figures, then those with trees.
nlohmann::ordered_json monthsJson(const std::vector<MonthFigures>& months,
                                  const std::vector<ShadedScore>& withTrees = {});

/// Stable keys with their units; lists months, and intervals with their weights.
std::string scoreJson(const ScoreAnswer& answer);

/// A heading and one line per month: month, sunlit minutes, weighted shade, shadow area, score; the latter
/// three also with trees.
std::string scoreCsv(const ScoreAnswer& answer);

}  // namespace noonmark
