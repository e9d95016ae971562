#include "render/gl/gl_errors.h"

#include <fmt/format.h>

#include "render/gl/gl_api.h"

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

}  // namespace noonmark
