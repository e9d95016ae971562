#pragma once

// The folder core/io reads cities, terrains and regions, and writes cities and rasters. readCity() (this
// file) reads any number of files: it detects each file's format (formats/, files/), calls its reader
// (pieces/read_part.h: footprints/, osm/, cityjson/, meshes/, terrain/), joins their pieces in one frame, and
// places buildings on the terrain. heights/ interprets attributes for all readers. read_region.h reads
// the region of a study, write_city.h and write_raster.h write GIS files. A file that uses a library has its
// name in the file name.

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/io/formats/format.h"
#include "core/io/heights/height_facts.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

/// The result of reading files.
struct CityRead {
    City
        city;  ///< its context: the water of OpenStreetMap's files, which is no ground; null if there is none
    Warnings warnings;
    std::string format;        ///< for display: "OpenStreetMap PBF"
    std::size_t features = 0;  ///< number of features read
    std::string attribution;   ///< of the data, if known ("(c) OpenStreetMap contributors")
    HeightFacts heights;       ///< where heights and bases were read from, and candidates to choose from
    std::string crs;           ///< coordinate reference systems, and who says so; empty where none is known
};

/// Reads one or more files into one city: footprints, 3D city models, meshes, terrain rasters
/// (formats/format.h lists them). The format is detected from the content, not only the name. The first file
/// with a position fixes the frame. A feature that cannot be used gives a warning; a file that cannot be used
/// at all gives an Error.
Result<CityRead> readCity(const std::vector<std::filesystem::path>& files, const ReadSettings& settings,
                          Progress& progress, std::stop_token stop, Formats formats = coreFormats());

}  // namespace noonmark
