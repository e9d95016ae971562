#include "render/view/software_drawing.h"

#include <QByteArray>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>
#include <array>

namespace noonmark {

namespace {

QByteArray askRenderer() {
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    if (!context.create() || !context.makeCurrent(&surface)) return {};
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const QByteArray renderer(name);
    context.doneCurrent();
    return renderer.toLower();
}

}  // namespace

bool drawsInSoftware() {
    static const bool software = [] {
        const QByteArray renderer = askRenderer();
        constexpr std::array<const char*, 4> names{"llvmpipe", "softpipe", "swiftshader", "software"};
        return std::ranges::any_of(names, [&](const char* name) { return renderer.contains(name); });
    }();
    return software;
}

}  // namespace noonmark
