#pragma once

#include <vector>

#include "core/study/verification/find_inputs.h"

namespace noonmark::cli {

/// Accepts a project that was saved again since the result, where all that the result rests on is as
/// recorded: city, edits of scenario and baseline, weights (hashContent()). Its file has another hash.
/// Projects that cannot be read stay as they were found.
void acceptLaterSaves(std::vector<FoundFile>& files, const nlohmann::ordered_json& record);

}  // namespace noonmark::cli
