#pragma once

#include <string>

namespace noonmark {

/// Confines PROJ to the files of its own folders, whatever a coordinate reference system names: parameters
/// such as +init=FILE and +nadgrids=FILE, which come from untrusted files through GDAL's drivers too, open
/// nothing else, and nothing is written. Call it before GDAL or PROJ is used. Backend: proj_files_proj.cpp.
void confineProj();

/// Whether one of PROJ's own folders holds a plain file of that name: "proj.db", "us_noaa_conus.tif".
[[nodiscard]] bool isProjFile(const std::string& name);

}  // namespace noonmark
