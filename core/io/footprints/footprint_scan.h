#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/geo/lon_lat.h"
#include "core/io/footprints/place_features.h"
#include "core/io/formats/format.h"
#include "core/io/heights/field_roles.h"

class GDALDataset;
class OGRLayer;

namespace noonmark {

/// What a file of buildings holds, found in one pass that stores no footprints: for plans of studies that are
/// larger than memory.
struct FootprintScan {
    /// Side of a cell of `tallestM`, degrees.
    static constexpr double cellDeg = 0.02;
    using Cell = std::pair<int, int>;  ///< floor(longitude / cellDeg), floor(latitude / cellDeg)

    Frame frame;                        ///< as readFootprints() chooses it
    LonLatBox box = emptyLonLatBox;     ///< around all features
    std::size_t features = 0;           ///< usable as buildings
    bool indexed = true;                ///< an extent of it is read without the rest
    bool hasTerrain = false;            ///< the file has a terrain too, which is not divided
    std::map<Cell, double> tallestM{};  ///< highest top above the ground among the features that touch a
                                        ///< cell; of a roof whose ground is unknown, at most its elevation

    void add(const UnplacedFeature& feature);
    void add(const Building& building, const Frame& frame);

private:
    void add(const LonLatBox& own, double heightM);
};

/// The same of a file of this format, which states its place. A file without a spatial index is read whole.
/// Errors as readCity().
Result<FootprintScan> scanBuildings(const std::filesystem::path& file, const Format& format,
                                    const ReadSettings& settings, Progress& progress, std::stop_token stop);

/// Errors as readFootprints(). Some 10 us a feature; memory 24 bytes a feature. Backend:
/// read_footprints_gdal.cpp.
Result<FootprintScan> scanFootprints(const std::filesystem::path& file, const ReadSettings& settings,
                                     Progress& progress, std::stop_token stop);

/// Second names of a layer's fields, for people, by index; empty where a field has none. A GeoPackage keeps
/// them in its table gpkg_data_columns, a file geodatabase with the fields. Backend: footprint_scan_gdal.cpp.
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

/// The same of a map that GDAL reads. Backend: footprint_scan_gdal.cpp.
Result<std::vector<ListedLayer>> listMapLayers(const std::filesystem::path& file, std::stop_token stop);

/// The same of its layers of points and its tables, as far as their first feature shows. Backend likewise.
Result<std::vector<ListedLayer>> listPointLayers(const std::filesystem::path& file, std::stop_token stop);

/// "12, 18.5, 9 (2.5 to 41.2 in 998 of 1,000 features)"; "no value in the first 1,000 features".
std::string describeValues(const ListedField& field, std::size_t sampled);

/// What a field is taken for if the user chooses none: "height", "storeys", "name"; empty for other roles.
std::string_view nameOfRole(std::optional<FieldRole> role);

}  // namespace noonmark
