#pragma once

#include <filesystem>

namespace noonmark::tests {

/// Writes a file geodatabase of three buildings and a plot. Defined in file_geodatabase_gdal.cpp.
void writeFileGeodatabase(const std::filesystem::path& folder);

}  // namespace noonmark::tests
