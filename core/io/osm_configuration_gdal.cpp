#include <cpl_vsi.h>
#include <fmt/format.h>

#include <atomic>
#include <string_view>

#include "core/io/osm_configuration.h"

namespace noonmark {

namespace {

constexpr std::string_view configuration = R"(closed_ways_are_polygons=building,building:part
attribute_name_laundering=no
[points]
osm_id=yes
other_tags=no
[lines]
osm_id=yes
other_tags=no
[multipolygons]
osm_id=yes
attributes=name,building,building:part,height,building:height,min_height,building:min_height,building:levels,building:min_level,roof:height,roof:levels,roof:shape,location,layer,status
other_tags=no
[multilinestrings]
osm_id=yes
other_tags=no
[other_relations]
osm_id=yes
other_tags=no
)";

// Of its own for every reader, so that two can read at a time.
std::string freshPath() {
    static std::atomic<unsigned> count = 0;
    return fmt::format("/vsimem/noonmark_osm_{}.ini", ++count);
}

}  // namespace

OsmConfiguration::OsmConfiguration() : path_(freshPath()) {
    if (VSILFILE* file = VSIFOpenL(path_.c_str(), "wb")) {
        VSIFWriteL(configuration.data(), 1, configuration.size(), file);
        VSIFCloseL(file);
    }
}

OsmConfiguration::~OsmConfiguration() { VSIUnlink(path_.c_str()); }

}  // namespace noonmark
