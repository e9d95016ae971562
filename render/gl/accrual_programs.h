#pragma once

#include "render/gl/gl_program.h"

namespace noonmark {

/// Draws depth maps: resources/shaders/accrual/throw.vert. Each instance goes to its own layer; the vertex
/// shader chooses the layer where the device supports that (GlLimits::layerInVertex), otherwise a geometry
/// shader does.
Result<GlProgram> drawingProgram(bool layerInVertex);

/// Tests receivers against the depth maps: look_up.comp.
Result<GlProgram> lookUpProgram();

}  // namespace noonmark
