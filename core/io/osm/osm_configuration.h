#pragma once

#include <string>

namespace noonmark {

/// The configuration file for GDAL's OpenStreetMap driver, in memory for the lifetime of this object. For
/// places it makes closed ways tagged as parks, squares, school grounds and other areas polygons, and gives
/// lines the tags of streets; for context it adds water, rails and trees. (Buildings are read without that
/// driver: readOsmMap.) During that time the driver writes its temporary files on this thread to the folder
/// for temporary files. Backend: osm_configuration_gdal.cpp.
class OsmConfiguration {
public:
    static OsmConfiguration forPlaces();
    static OsmConfiguration forContext();
    ~OsmConfiguration();
    OsmConfiguration(const OsmConfiguration&) = delete;
    OsmConfiguration& operator=(const OsmConfiguration&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }

private:
    explicit OsmConfiguration(const std::string& text);

    std::string path_;
    std::string oldTemporaryFolder_;
};

}  // namespace noonmark
