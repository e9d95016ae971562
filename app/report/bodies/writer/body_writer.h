#pragma once

// The folder app/report/bodies/writer is a library of its own, noonmark-body-writer, which is loaded when the
// first body is written (../body_files.cpp): no other command pays for loading Assimp. It links Assimp and
// nothing else.

#include <cstddef>

namespace noonmark {

/// A body as triangles. The caller owns the arrays.
struct WrittenBody {
    const char* name = nullptr;       ///< UTF-8
    const float* vertices = nullptr;  ///< x, y, z of each
    std::size_t vertexCount = 0;
    const unsigned* corners = nullptr;  ///< three a triangle
    std::size_t triangleCount = 0;
};

/// Writes the file in a format of Assimp ("glb2"). Null, or what went wrong: a text that stays until the next
/// call. What noonmarkWriteBodies, the only function of the library, is.
using WriteBodies = const char* (*)(const char* file, const char* format, const WrittenBody* bodies,
                                    std::size_t count);
inline constexpr const char* writeBodiesName = "noonmarkWriteBodies";

}  // namespace noonmark
