#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace Assimp {
class IOSystem;
}

namespace noonmark {

/// File access for Assimp: the mesh itself (or `content` in its place, where that is not empty) and plain
/// files in its folder, read only; all other files appear not to exist. Reading always ends: it throws (which
/// Assimp turns into its error) if a reader loops at the end of a file, as Assimp's PLY reader does on a
/// broken one. Backend: guarded_files_assimp.cpp.
std::unique_ptr<Assimp::IOSystem> guardedFiles(const std::filesystem::path& mesh, std::string content = {});

}  // namespace noonmark
