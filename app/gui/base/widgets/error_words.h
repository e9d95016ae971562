#pragma once

#include <QString>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace noonmark {

/// What is wrong, where, and what to do: Error::text(), in the language of the window where the error is one
/// of the window's own. Errors of core are English.
QString describeError(const Error& error);

/// Why scenarios could not be computed, by name.
using ScenarioErrors = std::vector<std::pair<std::string, Error>>;

/// One error about all of them, of which there is at least one: if they have the same, that one, with their
/// names unless all `asked` have it. The dock Scenarios states each one's.
Error sumUp(const ScenarioErrors& errors, std::size_t asked);

}  // namespace noonmark
