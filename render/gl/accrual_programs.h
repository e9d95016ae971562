#pragma once

#include "render/gl/gl_program.h"

namespace noonmark {

/// Draws depth maps: resources/shaders/accrual/throw.vert; each instance goes to a layer of its own, chosen
/// in the vertex shader where the device can (GlLimits::layerInVertex), else in a geometry shader.
Result<GlProgram> drawingProgram(bool layerInVertex);

/// Tests receivers against them: look_up.comp.
Result<GlProgram> lookUpProgram();

}  // namespace noonmark
