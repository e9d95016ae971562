#pragma once

#include <filesystem>
#include <vector>

namespace noonmark {

/// The files that are read along with a file, whether they exist or not: .dbf, .shx, .prj and .cpg of a
/// shapefile, .bin of a glTF, .prj and .tfw of a raster. Determined by the file's extension; nothing is
/// opened.
std::vector<std::filesystem::path> listCompanionFiles(const std::filesystem::path& file);

}  // namespace noonmark
