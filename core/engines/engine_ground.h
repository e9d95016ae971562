#pragma once

#include <string_view>

namespace noonmark {

/// Whether an engine of core (engine_registry.h) takes level ground only: it refuses terrain and receivers on
/// roofs. To be said before anybody asks it.
bool onLevelGroundOnly(std::string_view engineKey);

}  // namespace noonmark
