#pragma once

#include "core/engines/api/engine_registry.h"

namespace noonmark {

/// The engines that draw with OpenGL, to be added to coreEngines(): "shadow-map-gl", the paper's baseline,
/// and "sam-gl". Empty where there is no OpenGL 4.3. Software OpenGL counts: it is slower than the engines
/// that run on the processor, but a baseline. Looks for a device on the first call, some 50 ms.
const EngineList& glEngines();

}  // namespace noonmark
