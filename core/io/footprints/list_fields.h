#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/formats/format.h"
#include "core/io/heights/field_roles.h"

class GDALDataset;
class OGRLayer;

namespace noonmark {

/// Second names of a layer's fields, for people, by index; empty where a field has none. A GeoPackage keeps
/// them in its table gpkg_data_columns, a file geodatabase with the fields. Backend: list_fields_gdal.cpp.
std::vector<std::string> listFieldAliases(GDALDataset& dataset, OGRLayer& layer);

/// A field of a layer, for people who choose one by what it holds.
struct ListedField {
    std::string name;
    std::string alias;                 ///< its second name, for people; empty: none
    std::size_t values = 0;            ///< of the features that were looked at
    std::optional<double> low, high;   ///< of its numbers; nothing: it holds none
    std::vector<std::string> samples;  ///< the first different values, as written, at most 40 bytes each
    std::optional<FieldRole> role;     ///< what its name says; nothing: unknown
};

/// A layer with polygons.
struct ListedLayer {
    std::string name;
    std::size_t features = 0;  ///< of the whole layer, as the file states it
    std::size_t sampled = 0;   ///< features that were looked at
    bool isRead = false;       ///< it is one of those that hold buildings (building_layers.h)
    std::vector<ListedField> fields;
};

/// The layers of a file with what their first 1,000 features hold, without reading the others: some
/// milliseconds. Empty for formats whose fields are always the same or that have none. Error: as readCity().
Result<std::vector<ListedLayer>> listLayers(const std::filesystem::path& file, const std::stop_token& stop,
                                            Formats formats = coreFormats());

/// The same of a map that GDAL reads. Backend: list_fields_gdal.cpp.
Result<std::vector<ListedLayer>> listMapLayers(const std::filesystem::path& file, std::stop_token stop);

/// "12, 18.5, 9 (2.5 to 41.2 in 998 of 1,000 features)"; "no value in the first 1,000 features".
std::string describeValues(const ListedField& field, std::size_t sampled);

/// What a field is taken for if the user chooses none: "height", "storeys", "name"; empty for other roles.
std::string_view nameOfRole(std::optional<FieldRole> role);

}  // namespace noonmark
