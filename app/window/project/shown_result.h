#pragma once

#include "app/window/study/result_rows.h"
#include "app/window/view/ground_answer.h"
#include "scenarios/project/results/saved_answer.h"

namespace noonmark {

/// A kept result of the project, ready to be shown again.
struct ShownResult {
    std::string name;
    std::string scenario;
    std::shared_ptr<const SavedAnswer> answer;
    double cellM = 1;
    std::vector<std::string> changes;        ///< of buildings and files since it was kept
    std::vector<std::string> weightChanges;  ///< of a score's weight table; changes while it is shown
    [[nodiscard]] bool upToDate() const { return changes.empty() && weightChanges.empty(); }
};

/// For a job. Error: as of readSavedAnswer().
Result<ShownResult> shownResult(const SavedResult& result, const Project& project);

/// The same beside the weight tables of a project that has changed; nothing where it stays as it is.
std::optional<ShownResult> reweigh(const ShownResult& result, const Project& project);

/// The note says that it is kept, since when, and whether something has changed: then it is marked.
GroundAnswer makeGroundAnswer(const ShownResult& result);

/// Its figures; before them what it is, where, when and by which version it was made.
std::vector<ResultRow> makeRows(const ShownResult& result);

/// What to say above the figures: that it is kept, and each change since.
QString describeSaved(const ShownResult& result);

/// Months of a score; none for other kinds.
std::vector<MonthFigures> monthsOf(const ShownResult& result);

}  // namespace noonmark
