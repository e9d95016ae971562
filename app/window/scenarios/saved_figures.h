#pragma once

#include <optional>
#include <string>

#include "scenarios/impact/impact_figures.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// The figures of a saved score or comparison, with what they depend on.
struct SavedFigures {
    std::string question;  ///< JSON: period, engine, cells and region's name
    Grid grid;
    std::optional<TimeWeights> weights;  ///< of a score
    double scoreM2 = 0;
    std::optional<ImpactFigures> impact;  ///< of a comparison, for its first threshold
};

/// Reads them if the project would still give this result; use it in a job. Nothing: another kind, damaged,
/// or out of date. Costs a hash of the scenario's city and of the baseline's.
std::optional<SavedFigures> readSavedFigures(const SavedResult& result, const Project& project);

/// Whether they were computed with these settings: period, cells, engine, and region by its name and extent.
bool haveSettings(const SavedFigures& saved, const StudySettings& settings);

}  // namespace noonmark
