#pragma once

#include <string>

#include "core/base/result.h"
#include "scenarios/edits/edit.h"

namespace noonmark {

/// An edit as the JSON of the project file (docs/project-file.md). Coordinates come back to the last bit.
std::string toJson(const Edit& edit);

/// `kind`: of getKind(). Error: JSON that is not that of an edit.
Result<Edit> parseEdit(const std::string& kind, const std::string& json);

}  // namespace noonmark
