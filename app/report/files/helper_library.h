#pragma once

#include <QFunctionPointer>

#include "core/base/result.h"

namespace noonmark {

/// A function of a library of ours that is loaded when it is first needed, and stays loaded. `library`:
/// "noonmark-movie-encoder"; `what`: what it does, "writes movies". It lies beside the program, or where an
/// installed program has its helpers. Error: it cannot be loaded, and why.
Result<QFunctionPointer> loadHelper(const char* library, const char* function, const char* what);

}  // namespace noonmark
