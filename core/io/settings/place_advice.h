#pragma once

#include <string>

#include "core/base/result.h"

namespace noonmark {

/// Advice for files that do not state their position on earth, or state an impossible one. All readers use
/// the same wording, so that the window can recognise it and offer the setting.
std::string crsAdvice();
std::string anchorAdvice();

/// Whether stating ReadSettings::crs or ReadSettings::meshAnchor could resolve the error: its advice is, or
/// begins with, one of the two above.
[[nodiscard]] bool asksForPlace(const Error& error);

}  // namespace noonmark
