#pragma once

namespace noonmark {

/// Prepares GDAL for files from strangers, once in the process (GdalCalls does it):
/// - only the drivers that Noonmark reads and writes with are registered. None of them runs SQL or code from
/// a
///   file, and none connects to a server. What GDAL opens by itself, such as overviews that a raster names,
///   can reach no other driver either;
/// - GDAL and PROJ get no network;
/// - of GDAL's virtual folders only /vsimem/ stays: no archives, no web or cloud storage, no standard input.
/// Backend: gdal_setup_gdal.cpp.
void setUpGdal();

}  // namespace noonmark
