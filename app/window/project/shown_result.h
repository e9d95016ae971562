#pragma once

#include "app/window/ground_answer.h"
#include "app/window/result_rows.h"
#include "scenarios/project/kept_answer.h"

namespace noonmark {

/// A kept result of the project, ready to be shown again.
struct ShownResult {
    std::string name;
    std::string scenario;
    std::shared_ptr<const KeptAnswer> answer;
    double cellM = 1;
    std::vector<std::string> changes;        ///< of buildings and files since it was kept
    std::vector<std::string> weightChanges;  ///< of a score's weight table; changes while it is shown
    [[nodiscard]] bool upToDate() const { return changes.empty() && weightChanges.empty(); }
};

/// For a job. Error: as of answerOf().
Result<ShownResult> shownResult(const KeptResult& result, const Project& project);

/// The same beside the weight tables of a project that has changed; nothing where it stays as it is.
std::optional<ShownResult> reweighed(const ShownResult& result, const Project& project);

/// The note says that it is kept, since when, and whether something has changed: then it is marked.
GroundAnswer groundAnswerOf(const ShownResult& result);

/// Its figures; before them what it is, where, when and by which version it was made.
std::vector<ResultRow> rowsOf(const ShownResult& result);

/// What to say above the figures: that it is kept, and each change since.
QString keptWords(const ShownResult& result);

/// Months of a score; none for other kinds.
std::vector<MonthFigures> monthsOf(const ShownResult& result);

}  // namespace noonmark
