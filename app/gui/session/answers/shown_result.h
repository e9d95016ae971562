#pragma once

#include "app/gui/base/layers/element_picture.h"
#include "app/gui/base/layers/ground_answer.h"
#include "app/gui/session/answers/result_rows.h"
#include "scenarios/project/results/saved_answer.h"

namespace noonmark {

/// A saved result of the project, ready for display.
struct ShownResult {
    std::string name;
    std::string scenario;
    std::shared_ptr<const SavedAnswer> answer;
    double cellM = 1;
    /// Changes of buildings and files since it was saved.
    std::vector<std::string> changes;
    /// Changes of a score's weight table; may change while the result is displayed.
    std::vector<std::string> weightChanges;
    [[nodiscard]] bool upToDate() const { return changes.empty() && weightChanges.empty(); }
};

/// For use in a job. Error: as of readSavedAnswer().
Result<ShownResult> shownResult(const SavedResult& result, const Project& project);

/// The result updated for the weight tables of a changed project; nothing if it stays as it is.
std::optional<ShownResult> reweigh(const ShownResult& result, const Project& project);

/// Its points, if it is a study at points.
std::optional<ElementView> makeElementView(const ShownResult& result);

/// Of another kind. The note states when the result was saved and whether anything has changed since; if so,
/// it is marked.
GroundAnswer makeGroundAnswer(const ShownResult& result);

/// Its figures, preceded by what it is, where, when and by which version it was computed.
std::vector<ResultRow> makeRows(const ShownResult& result);

/// The text above the figures: when the result was saved, and each change since.
QString describeSaved(const ShownResult& result);

/// The months of a score; none for other kinds of results.
std::vector<MonthFigures> monthsOf(const ShownResult& result);

}  // namespace noonmark
