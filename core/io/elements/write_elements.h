#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/geo/frame.h"
#include "core/io/styles/qgis_style.h"
#include "core/receivers/place.h"

namespace noonmark {

/// A value of a table of elements: a text, a whole number, a number (NaN: none), or nothing.
using ElementValue = std::variant<std::monostate, std::string, std::int64_t, double>;

inline constexpr int placeDecimals = 8;  ///< degrees need more digits than metres

struct ElementColumn {
    std::string name;   ///< lower case, unit at the end: "azimuth_deg"
    ElementValue kind;  ///< any value of the column's kind; not std::monostate
    int decimals = 3;   ///< of numbers in files
};

/// One row for each element. Columns are the same for files of any format.
struct ElementTable {
    std::vector<ElementColumn> columns;
    std::vector<std::vector<ElementValue>> rows;  ///< each as long as `columns`
    std::vector<glm::dvec3> places;  ///< of the rows: longitude, latitude (degrees), elevation (metres)
};

/// Writes the table as a GeoPackage with a layer "elements" of PointZ in longitude and latitude
/// (EPSG:4326); z is in the vertical datum of the city's data, as the layer's description states.
/// `style`: the layer's style in QGIS, stored in the file. Error: the file cannot be written. Some 4 us a
/// row. Backend: write_elements_gdal.cpp.
Result<void> writeElementsGeoPackage(const std::filesystem::path& file, const ElementTable& table,
                                     const LayerStyle& style = {});

/// Writes a row for each place as a GeoPackage with a layer "places" of polygons in longitude and latitude
/// (EPSG:4326). `table.places` is not used. `style`: as above. Error: the file cannot be written.
Result<void> writePlacesGeoPackage(const std::filesystem::path& file, const Frame& frame,
                                   const std::vector<Place>& places, const ElementTable& table,
                                   const LayerStyle& style = {});

/// How a layer of polygons is called, and what it says of itself.
struct NamedLayer {
    const char* name;
    const char* description;
};
/// The same of polygons that are no places.
Result<void> writePolygonsGeoPackage(const std::filesystem::path& file, const Frame& frame,
                                     const NamedLayer& layer, const std::vector<Place>& polygons,
                                     const ElementTable& table, const LayerStyle& style = {});

}  // namespace noonmark
