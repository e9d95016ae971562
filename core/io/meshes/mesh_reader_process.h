#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>

#include "core/io/meshes/mesh_scene.h"

namespace noonmark {

/// What the process that reads a mesh may use.
struct MeshReaderLimits {
    std::uint64_t memoryBytes = std::uint64_t(8) << 30;  ///< of address space; less for small files
    double cpuSeconds = 300;                             ///< 1 and more
    double seconds = 1200;                               ///< from start to end
    std::uint64_t resultBytes = std::uint64_t(1) << 30;  ///< about thirty million triangles
};

/// Limits for a file of so many bytes: time grows by a second (of processor) for each megabyte, memory is
/// half of this machine's, at most 8 GiB. Generous, since a stop ends it at any time: the library takes a
/// minute and more for an OBJ of 200,000 objects.
MeshReaderLimits meshReaderLimits(std::uintmax_t fileBytes);

/// Reads a mesh file (OBJ, PLY, glTF 2) in a process of its own, since the library that does so can crash or
/// run out of memory on a file from a stranger. The program noonmark-mesh-reader is looked for beside the
/// running program and in ../libexec/noonmark. An Error says what became of the process: out of memory,
/// crashed, took too long. A stop ends the process within 0.1 s. Costs about 10 ms beyond the reading.
/// Backend: mesh_reader_process_posix.cpp.
Result<MeshScene> readMeshScene(const std::filesystem::path& file, const MeshReaderLimits& limits,
                                const std::stop_token& stop);

/// How the reader process ends when memory was refused; it has no other way to say so.
inline constexpr int exitOutOfMemory = 3;
/// The file descriptor that it writes the scene to; its standard output is closed to the library's messages.
inline constexpr int sceneDescriptor = 3;

}  // namespace noonmark
