#pragma once

#include <string>

namespace noonmark {

/// The configuration that GDAL's OpenStreetMap driver asks for, as a file in memory while this lives: closed
/// ways tagged building or building:part are polygons, and the tags that make heights and parts are columns
/// under their own names. What the driver puts aside on this thread goes to the folder for temporary files.
/// Backend: osm_configuration_gdal.cpp.
class OsmConfiguration {
public:
    /// `heightTag`, `levelsTag`: the user's own, columns too; may be empty.
    OsmConfiguration(const std::string& heightTag, const std::string& levelsTag);
    ~OsmConfiguration();
    OsmConfiguration(const OsmConfiguration&) = delete;
    OsmConfiguration& operator=(const OsmConfiguration&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::string path_;
    std::string oldTemporaryFolder_;
};

}  // namespace noonmark
