#pragma once

namespace noonmark {

/// Whether OpenGL draws on the processor (llvmpipe, softpipe, SwiftShader), where each pixel and each core
/// counts. Asks once, with a context of its own: about 50 ms. False without OpenGL. Needs a QGuiApplication.
bool drawsInSoftware();

}  // namespace noonmark
