#include "render/gl/accrual_programs.h"

#include "generated/accrual_shaders.h"

namespace noonmark {

namespace {

std::string head(bool layerInVertex) {
    std::string text = "#version 430 core\n";
    if (layerInVertex)
        text += "#extension GL_ARB_shader_viewport_layer_array : require\n#define LAYER_IN_VERTEX\n";
    return text;
}

}  // namespace

Result<GlProgram> drawingProgram(bool layerInVertex) {
    std::vector<GlProgram::Stage> stages{{GL_VERTEX_SHADER, shaders::throwVertex},
                                         {GL_FRAGMENT_SHADER, shaders::depthFragment}};
    if (!layerInVertex) stages.push_back({GL_GEOMETRY_SHADER, shaders::layerGeometry});
    return GlProgram::make(head(layerInVertex), stages);
}

Result<GlProgram> lookUpProgram() {
    return GlProgram::make(head(false), {{GL_COMPUTE_SHADER, shaders::lookUpCompute}});
}

}  // namespace noonmark
