#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <tuple>

namespace noonmark {

/// How a polygon of a KML file stands: GDAL's reader has its altitudes, but not what they count from.
enum class KmlStanding {
    onGround,  ///< clampToGround: its altitudes are ignored
    extruded,  ///< its walls reach from the ground to its altitude above the ground
    floating,  ///< at its altitude above the ground, without walls
    absolute,  ///< at its altitude above sea level
};

/// The polygons of a KML file by the first corner of their outer ring.
class KmlAltitudes {
public:
    using Corner = std::tuple<double, double, double>;  ///< longitude, latitude, altitude

    /// Nothing for a file that is not XML or larger than 256 MiB. Reads the whole file; memory some ten times
    /// its size. Backend: kml_altitudes_gdal.cpp.
    static KmlAltitudes of(const std::filesystem::path& file);

    [[nodiscard]] std::optional<KmlStanding> find(const Corner& firstCorner) const;

private:
    std::map<Corner, KmlStanding> standing_;
};

}  // namespace noonmark
