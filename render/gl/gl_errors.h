#pragma once

#include "core/base/result.h"

namespace noonmark {

/// What went wrong in the current context since the last call, if anything; `doing` is shown as the place.
Result<void> checkGlErrors(const char* doing);

}  // namespace noonmark
