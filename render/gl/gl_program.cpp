#include "render/gl/gl_program.h"

#include <fmt/format.h>

namespace noonmark {

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

}  // namespace noonmark
