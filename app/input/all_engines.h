#pragma once

#include <string_view>

#include "core/engines/api/engine_registry.h"

namespace noonmark {

/// The engines of core and of the lab (core/lab), followed by the OpenGL engines where OpenGL 4.3 is
/// available. The first call looks for a graphics device.
const EngineList& allEngines();

/// The list in which to look up a key: coreAndLabEngines() where it contains the key, which avoids the search
/// for a graphics device.
const EngineList& enginesWith(std::string_view key);

/// Whether an engine of allEngines() requires level ground.
bool takesLevelGroundOnly(std::string_view key);

}  // namespace noonmark
