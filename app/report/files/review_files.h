#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/files/check_output.h"
#include "core/io/shadows/shadow_drawing.h"
#include "core/study/text/review_text.h"

namespace noonmark {

/// The files of a review: review.json, review.csv, shadows.dxf and shadows.gpkg.
std::vector<std::string> reviewFileNames();

/// Writes the files of a review into a folder, which is created if missing; all or none. `rules`: which files
/// may be replaced. Returns the paths written.
Result<std::vector<std::filesystem::path>> writeReviewFiles(const ReviewStudy& study,
                                                            const ReviewLabels& labels,
                                                            const ShadowDrawing& shadows,
                                                            const std::filesystem::path& folder,
                                                            const OutputRules& rules = {});

}  // namespace noonmark
