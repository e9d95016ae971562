#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"

namespace noonmark {

/// Capabilities of a device.
struct GlLimits {
    std::string device;  ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string version;
    int mapSize = 0;             ///< largest texture, texels per side
    int layers = 0;              ///< of a texture array
    bool layerInVertex = false;  ///< the vertex shader may choose the layer; otherwise a geometry shader must
    bool software = false;       ///< rendered on the CPU
};

/// OpenGL 4.3 without a window, on the first device that supports it, graphics cards before software (EGL, no
/// surface). Coexists with window contexts in the same process. Not bound to a thread: make it current while
/// drawing, in one thread at a time.
class GlContext {
public:
    /// Error: no OpenGL 4.3 or later. About 50 ms.
    static Result<std::shared_ptr<const GlContext>> make();
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    [[nodiscard]] const GlLimits& limits() const { return limits_; }

    /// Makes the context current in the calling thread for the lifetime of this object, then restores the
    /// previous one.
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
