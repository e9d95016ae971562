#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "render/lab/gl_api.h"
#include "render/lab/gl_context.h"

namespace noonmark {

struct GlContext::Handles {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
};

struct GlContext::Current::Before {
    EGLDisplay display = eglGetCurrentDisplay();
    EGLContext context = eglGetCurrentContext();
    EGLSurface draw = eglGetCurrentSurface(EGL_DRAW);
    EGLSurface read = eglGetCurrentSurface(EGL_READ);
    EGLDisplay ours = EGL_NO_DISPLAY;
};

namespace {

bool hasExtension(const char* list, std::string_view name) {
    return list != nullptr && std::string_view(list).find(name) != std::string_view::npos;
}

template <class Function>
Function functionOf(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

// The displays of all devices, graphics cards first, then Mesa's surfaceless display.
std::vector<EGLDisplay> displays() {
    const auto query = functionOf<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    const auto text = functionOf<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    std::vector<EGLDisplay> cards, others;
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    if (query != nullptr && text != nullptr && query(16, devices, &count) == EGL_TRUE)
        for (EGLint i = 0; i < count; ++i) {
            const bool software = hasExtension(text(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
            (software ? others : cards)
                .push_back(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
        }
    cards.insert(cards.end(), others.begin(), others.end());
    cards.push_back(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    return cards;
}

EGLContext contextOn(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE ||
        eglBindAPI(EGL_OPENGL_API) != EGL_TRUE)
        return EGL_NO_CONTEXT;
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                             4,
                             EGL_CONTEXT_MINOR_VERSION,
                             3,
                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                             EGL_NONE};
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
}

std::string formatText(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}

int numberOf(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

bool choosesLayerInVertex() {
    for (GLuint i = 0; i < GLuint(numberOf(GL_NUM_EXTENSIONS)); ++i)
        if (hasExtension(reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i)),
                         "GL_ARB_shader_viewport_layer_array"))
            return true;
    return false;
}

GlLimits limitsOfCurrent() {
    GlLimits limits;
    limits.device = formatText(GL_RENDERER);
    limits.version = formatText(GL_VERSION);
    limits.mapSize = numberOf(GL_MAX_TEXTURE_SIZE);
    limits.layers = numberOf(GL_MAX_ARRAY_TEXTURE_LAYERS);
    limits.layerInVertex = choosesLayerInVertex();
    limits.software =
        hasExtension(limits.device.c_str(), "llvmpipe") || hasExtension(limits.device.c_str(), "softpipe");
    return limits;
}

}  // namespace

GlContext::GlContext(std::unique_ptr<const Handles> handles) : handles_(std::move(handles)) {}

Result<std::shared_ptr<const GlContext>> GlContext::make() {
    for (EGLDisplay display : displays()) {
        const EGLContext context = contextOn(display);
        if (context == EGL_NO_CONTEXT) continue;
        const std::shared_ptr<GlContext> made(
            new GlContext(std::make_unique<const Handles>(Handles{display, context})));
        const Current current(*made);
        if (eglGetCurrentContext() != context) continue;
        made->limits_ = limitsOfCurrent();
        return made;
    }
    return failure("There is no OpenGL 4.3 on this machine", "OpenGL",
                   "Choose an engine that runs on the processor, or install the graphics card's driver");
}

// The display stays open: a process has one per device, and other code may be using it.
GlContext::~GlContext() { eglDestroyContext(handles_->display, handles_->context); }

GlContext::Current::Current(const GlContext& context) {
    Before before;
    before.ours = context.handles_->display;
    before_ = std::make_unique<const Before>(before);
    eglBindAPI(EGL_OPENGL_API);
    eglMakeCurrent(before.ours, EGL_NO_SURFACE, EGL_NO_SURFACE, context.handles_->context);
}

GlContext::Current::~Current() {
    if (before_->context == EGL_NO_CONTEXT)
        eglMakeCurrent(before_->ours, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    else
        eglMakeCurrent(before_->display, before_->draw, before_->read, before_->context);
}

}  // namespace noonmark
