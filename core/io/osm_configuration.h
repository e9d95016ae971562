#pragma once

#include <string>

namespace noonmark {

/// The configuration that GDAL's OpenStreetMap driver asks for, as a file in memory while this lives: closed
/// ways tagged building or building:part are polygons, and the tags that make heights and parts are columns
/// under their own names. Backend: osm_configuration_gdal.cpp.
class OsmConfiguration {
public:
    OsmConfiguration();
    ~OsmConfiguration();
    OsmConfiguration(const OsmConfiguration&) = delete;
    OsmConfiguration& operator=(const OsmConfiguration&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::string path_;
};

}  // namespace noonmark
