#pragma once

#include <filesystem>
#include <memory>

namespace Assimp {
class IOSystem;
}

namespace noonmark {

/// Files for Assimp: the mesh itself and plain files in its folder, read only; others are not there. Reading
/// ends: it throws (which Assimp turns into its error) when a reader goes round and round at the end of a
/// file, as Assimp's PLY reader does on a broken one. Backend: guarded_files_assimp.cpp.
std::unique_ptr<Assimp::IOSystem> guardedFiles(const std::filesystem::path& mesh);

}  // namespace noonmark
