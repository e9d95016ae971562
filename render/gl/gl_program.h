#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "render/gl/gl_api.h"

namespace noonmark {

/// A linked program of the current context.
class GlProgram {
public:
    struct Stage {
        GLenum kind;  ///< GL_VERTEX_SHADER, ...
        const char* text;
    };
    /// `head` precedes each stage: version and switches. Error with the driver's message.
    static Result<GlProgram> make(const std::string& head, const std::vector<Stage>& stages);
    ~GlProgram();
    GlProgram(GlProgram&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlProgram& operator=(GlProgram&&) = delete;

    void use() const { glUseProgram(name_); }
    /// -1, which OpenGL ignores, for uniforms that the driver optimised away.
    [[nodiscard]] GLint uniform(const char* name) const { return glGetUniformLocation(name_, name); }

private:
    explicit GlProgram(GLuint name) : name_(name) {}
    GLuint name_ = 0;
};

}  // namespace noonmark
