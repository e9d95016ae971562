#pragma once

#include <string>
#include <vector>

class GDALDataset;
class OGRLayer;

namespace noonmark {

/// Second names of a layer's fields, for people, by index; empty where a field has none. A GeoPackage keeps
/// them in its table gpkg_data_columns, a file geodatabase with the fields. Backend: field_aliases_gdal.cpp.
std::vector<std::string> listFieldAliases(GDALDataset& dataset, OGRLayer& layer);

}  // namespace noonmark
