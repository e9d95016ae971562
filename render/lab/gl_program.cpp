#include "render/lab/gl_program.h"

#include <fmt/format.h>

#include "generated/accrual_shaders.h"

namespace noonmark {

Result<void> checkGlErrors(const char* doing) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return {};
    while (glGetError() != GL_NO_ERROR) continue;
    if (error == GL_OUT_OF_MEMORY)
        return failure("The graphics device does not have enough memory", doing, "Choose a smaller map");
    return failure(fmt::format("The graphics device failed (OpenGL error {:#x})", error), doing,
                   "Choose an engine that runs on the processor");
}

namespace {

constexpr GLsizei longestLog = 4096;

std::string logOf(GLuint name, decltype(&glGetShaderInfoLog) read) {
    std::string log(longestLog, '\0');
    GLsizei length = 0;
    read(name, longestLog, &length, log.data());
    log.resize(std::size_t(length));
    return log;
}

tl::unexpected<Error> refused(const std::string& log) {
    return failure(fmt::format("The graphics driver rejects a shader: {}", log), "OpenGL",
                   "Choose an engine that runs on the processor, or update the graphics card's driver");
}

Result<GLuint> compileStage(const std::string& head, const GlProgram::Stage& stage) {
    const GLuint shader = glCreateShader(stage.kind);
    const char* texts[] = {head.c_str(), stage.text};
    glShaderSource(shader, 2, texts, nullptr);
    glCompileShader(shader);
    GLint done = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done == GL_TRUE) return shader;
    const std::string log = logOf(shader, glGetShaderInfoLog);
    glDeleteShader(shader);
    return refused(log);
}

}  // namespace

Result<GlProgram> GlProgram::make(const std::string& head, const std::vector<Stage>& stages) {
    GlProgram program(glCreateProgram());
    for (const Stage& stage : stages) {
        const auto shader = compileStage(head, stage);
        if (!shader) return tl::make_unexpected(shader.error());
        glAttachShader(program.name_, *shader);
        glDeleteShader(*shader);  // deleted together with the program
    }
    glLinkProgram(program.name_);
    GLint done = GL_FALSE;
    glGetProgramiv(program.name_, GL_LINK_STATUS, &done);
    if (done != GL_TRUE) return refused(logOf(program.name_, glGetProgramInfoLog));
    return program;
}

GlProgram::~GlProgram() {
    if (name_ != 0) glDeleteProgram(name_);
}

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
