#pragma once

#include <string>

#include "core/result.h"
#include "scenarios/edits/edit.h"

namespace noonmark {

/// An edit as the JSON of the project file (docs/project-file.md). Coordinates come back to the last bit.
std::string jsonOf(const Edit& edit);

/// `kind`: of kindOf(). Error: JSON that is not that of an edit.
Result<Edit> editOf(const std::string& kind, const std::string& json);

}  // namespace noonmark
