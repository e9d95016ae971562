#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <fmt/format.h>

#include <atomic>
#include <filesystem>
#include <string_view>

#include "core/io/osm/osm_configuration.h"

namespace noonmark {

namespace {

// The driver understands the key "area" by itself; named here, it would turn that off for all.
constexpr const char* placeConfiguration =
    R"(closed_ways_are_polygons=leisure,landuse,amenity,historic,natural,place,tourism,building
attribute_name_laundering=no
[points]
osm_id=yes
other_tags=no
[lines]
osm_id=yes
attributes=name,highway,width,lanes,area,tunnel,layer,location
other_tags=no
[multipolygons]
osm_id=yes
attributes=name,leisure,landuse,amenity,historic,natural,place,highway,tourism,building,location,layer,tunnel
other_tags=no
[multilinestrings]
osm_id=yes
other_tags=no
[other_relations]
osm_id=yes
other_tags=no
)";

constexpr const char* contextConfiguration =
    R"(closed_ways_are_polygons=leisure,landuse,amenity,natural,place,water,building
attribute_name_laundering=no
[points]
osm_id=yes
attributes=natural
other_tags=no
[lines]
osm_id=yes
attributes=name,highway,railway,waterway,width,lanes,area,tunnel,layer,location
other_tags=no
[multipolygons]
osm_id=yes
attributes=name,leisure,landuse,amenity,natural,place,highway,waterway,building,location,layer,tunnel
other_tags=no
[multilinestrings]
osm_id=yes
other_tags=no
[other_relations]
osm_id=yes
other_tags=no
)";

// A separate path for every reader, so that two can read at the same time.
std::string freshPath() {
    static std::atomic<unsigned> count = 0;
    return fmt::format("/vsimem/noonmark_osm_{}.ini", ++count);
}

constexpr const char* temporaryFolder = "CPL_TMPDIR";

}  // namespace

OsmConfiguration OsmConfiguration::forPlaces() { return OsmConfiguration(std::string(placeConfiguration)); }

OsmConfiguration OsmConfiguration::forContext() {
    return OsmConfiguration(std::string(contextConfiguration));
}

OsmConfiguration::OsmConfiguration(const std::string& text) : path_(freshPath()) {
    if (VSILFILE* file = VSIFOpenL(path_.c_str(), "wb")) {
        VSIFWriteL(text.data(), 1, text.size(), file);
        VSIFCloseL(file);
    }
    if (const char* old = CPLGetThreadLocalConfigOption(temporaryFolder, nullptr)) oldTemporaryFolder_ = old;
    std::error_code none;
    const auto folder = std::filesystem::temp_directory_path(none);
    if (!none) CPLSetThreadLocalConfigOption(temporaryFolder, folder.c_str());
}

OsmConfiguration::~OsmConfiguration() {
    VSIUnlink(path_.c_str());
    CPLSetThreadLocalConfigOption(temporaryFolder,
                                  oldTemporaryFolder_.empty() ? nullptr : oldTemporaryFolder_.c_str());
}

}  // namespace noonmark
