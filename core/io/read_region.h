#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/geo/lon_lat.h"
#include "core/io/read_city.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// The part of a city to read.
struct ReadExtent {
    /// Only the features that touch this box are read, from footprints with a spatial index; other files are
    /// read whole. Finding none is no error.
    LonLatBox box;
    /// A terrain that was read before in the same frame: files of terrain are not read. Null: they are,
    /// whole.
    std::shared_ptr<const Terrain> terrain;
    /// The box around each of the files, in their order: files that do not touch `box` are not opened. Empty:
    /// unknown.
    std::vector<LonLatBox> fileBoxes{};
};

/// readCity() of a part, in the frame of `settings`, which must be set. Buildings are complete if the box
/// contains all their features, and the same to the last bit and in the same order as in the whole city.
Result<CityRead> readCityExtent(const std::vector<std::filesystem::path>& files, const ReadSettings& settings,
                                const ReadExtent& window, Progress& progress, std::stop_token stop);

/// Reads a region: "W,S,E,N" in degrees, "POLYGON ((lon lat, ...))" or MULTIPOLYGON in degrees, or the path
/// of a polygon file (any vector format that GDAL knows, any CRS; all polygons of all its layers together,
/// repaired if invalid). Long sides in the file's CRS get extra points, so that they follow the curves of the
/// projection. Error: none of these, no polygon, no CRS, coordinates that cannot belong to the CRS, or a
/// place more than 200 km from the frame's origin. Backend: read_region_gdal.cpp.
Result<Region> readRegion(const std::string& boxOrFile, const Frame& frame);

}  // namespace noonmark
