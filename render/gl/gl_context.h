#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"

namespace noonmark {

/// What a device can do.
struct GlLimits {
    std::string device;  ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string version;
    int mapSize = 0;             ///< texels a side of the largest texture
    int layers = 0;              ///< of a texture array
    bool layerInVertex = false;  ///< a vertex shader may choose the layer; else a geometry shader does
    bool software = false;       ///< drawn by the processor
};

/// OpenGL 4.3 without a window, on the first device that has it, graphics cards before software (EGL, no
/// surface). Lives beside the contexts of a window in the same process. Not bound to a thread: whoever draws
/// makes it current for as long as that takes, one thread at a time.
class GlContext {
public:
    /// Error where there is no OpenGL, or none of 4.3 or later. Some 50 ms.
    static Result<std::shared_ptr<const GlContext>> make();
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    [[nodiscard]] const GlLimits& limits() const { return limits_; }

    /// While it lives the calling thread draws into this context; what was current before comes back.
    class Current {
    public:
        explicit Current(const GlContext& context);
        ~Current();
        Current(const Current&) = delete;
        Current& operator=(const Current&) = delete;

    private:
        struct Before;
        std::unique_ptr<const Before> before_;
    };

private:
    struct Handles;
    explicit GlContext(std::unique_ptr<const Handles> handles);
    std::unique_ptr<const Handles> handles_;
    GlLimits limits_;
};

}  // namespace noonmark
