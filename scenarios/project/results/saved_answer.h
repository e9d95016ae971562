#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/measures/statistics.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/project/project.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// How a kept result was made, by its own settings.
struct SavedOrigin {
    std::string at;              ///< UTC, "2026-11-22T03:10:28Z"; empty: a version kept it that did not say
    std::string citySha256;      ///< cityHash() of the scenario then; empty likewise
    std::string baselineSha256;  ///< impact: of the baseline
    std::string program;         ///< "Noonmark 0.1.0"
    std::string engine;          ///< name and settings in words
    std::string period;          ///< in words
    std::string region;          ///< its name; may be empty
    std::optional<TimeWeights> weights;  ///< score: the table as it was; none where nobody said
};

struct SavedStudy {
    ShadowField field;  ///< without cost and warnings
    ShadowStatistics statistics;
    std::uint64_t steps = 0;         ///< of the sun
    std::uint64_t belowHorizon = 0;  ///< that were left out
    double seconds = 0;              ///< that the engine took; 0: not said
    std::string error;               ///< against the ray reference, in words
};

struct SavedImpact {
    Impact impact;  ///< versions that did not keep which cells were built over left them like those outside
    ComparisonFigures figures;
};

struct SavedScore {
    Score score;
    std::string weights;  ///< name of the table
};

/// A kept result made whole again, with the figures it was kept with.
struct SavedAnswer {
    SavedOrigin origin;
    std::variant<SavedStudy, SavedImpact, SavedScore> answer;
};

/// Copies the layers. Error: settings or layers that are not those of its kind.
Result<SavedAnswer> readSavedAnswer(const SavedResult& result);

/// Why the project as it is now would not give this result, a whole sentence each; none where it would: other
/// buildings, terrain or files. Costs a hash of the scenario's city, and of the baseline's.
std::vector<std::string> findChangesSince(const SavedResult& result, const SavedOrigin& origin,
                                          const Project& project);

/// The same of a score's weight table; at once.
std::vector<std::string> findWeightChangesSince(const SavedOrigin& origin, const Project& project);

}  // namespace noonmark
