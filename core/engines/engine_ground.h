#pragma once

#include <string_view>

namespace noonmark {

/// Whether an engine of core (engine_registry.h) supports level ground only, that is, refuses terrain and
/// receivers on roofs. Lets the interface report this before a run.
bool onLevelGroundOnly(std::string_view engineKey);

}  // namespace noonmark
