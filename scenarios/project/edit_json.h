#pragma once

#include <string>

#include "core/base/result.h"
#include "scenarios/edits/edit.h"

namespace noonmark {

/// The JSON of an edit in the project file (docs/project-file.md). Coordinates round-trip exactly.
std::string toJson(const Edit& edit);

/// `kind`: as returned by getKind(). Error: the JSON is not that of an edit.
Result<Edit> parseEdit(const std::string& kind, const std::string& json);

}  // namespace noonmark
