#pragma once

#include <string_view>

#include "core/engines/api/engine_registry.h"

namespace noonmark {

/// Core's engines, and after them those that draw with OpenGL, where there is OpenGL 4.3. Looks for a
/// graphics device on the first call.
const EngineList& allEngines();

/// The list to look a key up in: core's where it is there, so that no graphics device is looked for in vain.
const EngineList& enginesWith(std::string_view key);

/// Whether an engine of allEngines() takes level ground only.
bool isOnLevelGroundOnly(std::string_view key);

}  // namespace noonmark
