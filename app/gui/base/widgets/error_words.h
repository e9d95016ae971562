#pragma once

#include <QString>

#include "core/base/result.h"

namespace noonmark {

/// What is wrong, where, and what to do: Error::text(), in the language of the window where the error is one
/// of the window's own. Errors of core are English.
QString describeError(const Error& error);

}  // namespace noonmark
