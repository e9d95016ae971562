#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "render/lab/gl_api.h"

namespace noonmark {

/// Owns one OpenGL name; created and deleted in the context that is current at that time.
template <auto Generate, auto Delete>
class GlName {
public:
    GlName() { Generate(1, &name_); }
    ~GlName() {
        if (name_ != 0) Delete(1, &name_);
    }
    GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    operator GLuint() const { return name_; }

private:
    GLuint name_ = 0;
};

using GlBuffer = GlName<&glGenBuffers, &glDeleteBuffers>;
using GlVertexArray = GlName<&glGenVertexArrays, &glDeleteVertexArrays>;
using GlTexture = GlName<&glGenTextures, &glDeleteTextures>;
using GlFramebuffer = GlName<&glGenFramebuffers, &glDeleteFramebuffers>;

/// Reports an OpenGL error in the current context since the last call; `doing` is the place shown in the
/// Error.
Result<void> checkGlErrors(const char* doing);

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

/// Draws depth maps: resources/shaders/accrual/throw.vert. Each instance goes to its own layer; the vertex
/// shader chooses the layer where the device supports that (GlLimits::layerInVertex), otherwise a geometry
/// shader does.
Result<GlProgram> drawingProgram(bool layerInVertex);

/// Tests receivers against the depth maps: look_up.comp.
Result<GlProgram> lookUpProgram();

}  // namespace noonmark
