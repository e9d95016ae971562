#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>

#include "core/io/meshes/mesh_scene.h"

namespace noonmark {

/// Resource limits of the process that reads a mesh.
struct MeshReaderLimits {
    std::uint64_t memoryBytes = std::uint64_t(8) << 30;  ///< address space; less for small files
    double cpuSeconds = 300;                             ///< at least 1
    double seconds = 1200;                               ///< from start to end
    std::uint64_t resultBytes = std::uint64_t(1) << 30;  ///< about thirty million triangles
};

/// Limits for a file of `fileBytes`: time grows by a second (of processor) for each megabyte, memory is half
/// of this machine's, at most 8 GiB. The limits are generous, since the user can stop the process at any
/// time: the library takes a minute and more for an OBJ of 200,000 objects.
MeshReaderLimits meshReaderLimits(std::uintmax_t fileBytes);

/// Reads a mesh file (OBJ, PLY, glTF 2, STL, COLLADA, IFC, DXF) in a separate process, since the mesh library
/// can crash or run out of memory on an untrusted file. The program noonmark-mesh-reader is looked for beside
/// the running program and where both are installed (../libexec/noonmark, seen from the program). The Error
/// says how the process failed: out of memory, crashed, took too long. A stop request ends the process within
/// 0.1 s. Costs about 10 ms beyond the reading. Backend: mesh_reader_process_posix.cpp.
Result<MeshScene> readMeshScene(const std::filesystem::path& file, const MeshReaderLimits& limits,
                                const std::stop_token& stop);

/// Exit status of the reader process if it could not allocate memory; it cannot report this in another way.
inline constexpr int exitOutOfMemory = 3;
/// File descriptor that the process writes the scene to; its standard output is closed, so that messages of
/// the library go nowhere.
inline constexpr int sceneDescriptor = 3;

}  // namespace noonmark
