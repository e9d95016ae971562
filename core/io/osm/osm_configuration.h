#pragma once

#include <string>

namespace noonmark {

/// The configuration file for GDAL's OpenStreetMap driver, in memory for the lifetime of this object. For
/// buildings it makes closed ways tagged building or building:part polygons, and gives the tags for heights
/// and parts columns of their own; for places it does so with parks, squares, school grounds and other areas,
/// and gives lines the tags of streets; for context it adds water, rails and
/// trees. During that time the driver writes its temporary files on this thread
/// to the folder for temporary files. Backend: osm_configuration_gdal.cpp.
class OsmConfiguration {
public:
    /// `heightTag`, `levelsTag`: tags that the user named; they become columns too; may be empty.
    OsmConfiguration(const std::string& heightTag, const std::string& levelsTag);
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
