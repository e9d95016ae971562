#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/files/answer_source.h"
#include "app/report/maps/change_scale.h"
#include "core/io/files/check_output.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// The files of a comparison, the same from the window and the command line, into a folder that is made when
/// missing: impact.tif, impact.png, impact.pdf, impact.json, impact.csv; region.geojson where the region
/// needs it. `rules`: what may be replaced. Returns the paths written; each file is whole or not there. Needs
/// a QGuiApplication (the `offscreen` platform will do).
Result<std::vector<std::filesystem::path>> writeImpactFiles(const ImpactAnswer& answer,
                                                            const AnswerSource& source,
                                                            const ChangeScale& scale,
                                                            const std::filesystem::path& folder,
                                                            const OutputRules& rules = {});

/// Likewise of a score: score.tif, score.png, score.pdf, score.json, score.csv.
Result<std::vector<std::filesystem::path>> writeScoreFiles(const ScoreAnswer& answer,
                                                           const AnswerSource& source,
                                                           const std::filesystem::path& folder,
                                                           const OutputRules& rules = {});

/// The names of those files, known before the work is done; `provenance` states the region.
std::vector<std::string> impactFileNames(const Provenance& provenance);
std::vector<std::string> scoreFileNames(const Provenance& provenance);

}  // namespace noonmark
