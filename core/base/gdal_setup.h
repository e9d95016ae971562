#pragma once

namespace noonmark {

/// Prepares GDAL for untrusted files, once in the process (GdalCalls calls it):
/// - Only the drivers that Noonmark reads and writes with are registered. None of them runs SQL or code from
///   a file, and none connects to a server. This also limits what GDAL opens on its own, such as overviews
///   that a raster names.
/// - GDAL and PROJ have no network access.
/// - Of GDAL's virtual file systems only /vsimem/ remains: no archives, no web or cloud storage, no standard
///   input. On disk it reads plain files only (gdal_files.h).
/// - PROJ opens the files of its own folders only (proj_files.h).
///
/// Backend: gdal_setup_gdal.cpp.
void setUpGdal();

}  // namespace noonmark
