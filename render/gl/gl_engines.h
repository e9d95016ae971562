#pragma once

#include "core/engines/api/engine_registry.h"

namespace noonmark {

/// The OpenGL engines that complement coreEngines(): "shadow-map-gl", with which the paper compares accrual
/// maps, and "sam-gl". Empty without OpenGL 4.3. Software OpenGL counts too: it is slower than the CPU
/// engines but allows the comparison. The first call looks for a device, about 50 ms.
const EngineList& glEngines();

}  // namespace noonmark
