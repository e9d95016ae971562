#pragma once

#include <filesystem>
#include <vector>

#include "app/report/answer_source.h"
#include "app/report/change_scale.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// The files of a comparison, the same from the window and the command line, into a folder that is made when
/// missing: impact.tif, impact.png, impact.pdf, impact.json, impact.csv. Returns the paths written; each file
/// is whole or not there. Needs a QGuiApplication (the `offscreen` platform will do).
Result<std::vector<std::filesystem::path>> writeImpactFiles(const ImpactAnswer& answer,
                                                            const AnswerSource& source,
                                                            const ChangeScale& scale,
                                                            const std::filesystem::path& folder);

/// Likewise of a score: score.tif, score.png, score.pdf, score.json, score.csv.
Result<std::vector<std::filesystem::path>> writeScoreFiles(const ScoreAnswer& answer,
                                                           const AnswerSource& source,
                                                           const std::filesystem::path& folder);

}  // namespace noonmark
