#pragma once

#include <utility>

#include "render/gl/gl_api.h"

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

}  // namespace noonmark
