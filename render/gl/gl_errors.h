#pragma once

#include "core/base/result.h"

namespace noonmark {

/// Reports an OpenGL error in the current context since the last call; `doing` is the place shown in the
/// Error.
Result<void> checkGlErrors(const char* doing);

}  // namespace noonmark
