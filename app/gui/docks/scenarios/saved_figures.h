#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/measures/statistics.h"
#include "core/study/provenance/study_hash.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/project/project.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// Figures of a scenario that were computed before, with what they depend on.
struct SavedFigures {
    std::string question;  ///< hashQuestion(); empty in results of versions that did not store it
    std::optional<ShadowStatistics> measured;  ///< of a study
    std::optional<ImpactFigures> impact;       ///< of a comparison, for its first threshold
    std::optional<TimeWeights> weights;        ///< of a score
    ScoreTotals score;
    std::vector<MonthFigures> scoreMonths;  ///< of it; empty in results of versions that did not save them
    std::vector<ShownError> scoreErrors{};  ///< likewise
    std::string settings;  ///< JSON: period, engine, cells and region's name, where there is no question
    Grid grid;             ///< likewise
};

/// Reads those of a saved result if the project would still give it; use it in a job. Nothing: another kind,
/// damaged, or out of date. Costs a hash of the scenario's city and of the baseline's.
std::optional<SavedFigures> readSavedFigures(const SavedResult& result, const Project& project);

/// Whether they were computed with these settings, of which `hashes` are those. Where the figures state
/// none, settings and the region's name and extent decide.
bool haveSettings(const SavedFigures& saved, const StudySettings& settings, const QuestionHashes& hashes);

/// Figures as they are saved in the project's view, so that they are there again when it is opened: they
/// count for a city of these hashes (hashCity), whatever its scenario is called.
struct ViewFigures {
    std::string citySha256;
    std::string baselineSha256;  ///< of a comparison
    SavedFigures figures;        ///< with a question
};
inline constexpr const char* viewFiguresKey = "figures";  ///< in Project::view

/// As JSON text, and back. Reads what is valid of any text, since the file may come from anywhere.
std::string formatText(const std::vector<ViewFigures>& saved);
std::vector<ViewFigures> parseViewFigures(const std::string& text);

}  // namespace noonmark
