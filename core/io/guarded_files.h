#pragma once

#include <memory>
#include <stop_token>

namespace Assimp {
class IOSystem;
}

namespace noonmark {

/// Files for Assimp whose reading ends: it throws (which Assimp turns into its error) when reading is
/// stopped, or goes round and round at the end of a file, as Assimp's PLY reader does on a broken one. Read
/// only. Backend: guarded_files_assimp.cpp.
std::unique_ptr<Assimp::IOSystem> guardedFiles(std::stop_token stop);

}  // namespace noonmark
