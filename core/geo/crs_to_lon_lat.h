#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"

namespace noonmark {

/// Takes places of a coordinate reference system to lon/lat on WGS84. Horizontal only: a compound system's
/// heights stay as they are. Not for two threads at once. Backend: crs_to_lon_lat_gdal.cpp.
class CrsToLonLat {
public:
    /// "EPSG:7415", "urn:ogc:def:crs:EPSG::7415", "https://www.opengis.net/def/crs/EPSG/0/7415", WKT, PROJ
    /// text. Nothing is fetched from the network. Error: not a system that is known, or not of the earth's
    /// surface.
    static Result<CrsToLonLat> of(const std::string& crs);

    CrsToLonLat(CrsToLonLat&&) noexcept;
    CrsToLonLat& operator=(CrsToLonLat&&) noexcept;
    ~CrsToLonLat();

    /// First easting or longitude, then northing or latitude, whatever order the system's authority prefers.
    /// NaN for points that are NaN or cannot be transformed. O(points), about 1 us each.
    [[nodiscard]] std::vector<LonLat> lonLat(std::span<const glm::dvec2> points) const;

    /// Whether a place can be meant: within 5 degrees of where the system is used; true where that is not
    /// known.
    [[nodiscard]] bool isPlausible(LonLat place) const;

    /// Metres per unit of its heights: of its vertical part; without one `elevationUnitIsStated` is false,
    /// and it is the horizontal unit if that is a length, else 1.
    [[nodiscard]] double metresPerElevationUnit() const;
    [[nodiscard]] bool elevationUnitIsStated() const;

    [[nodiscard]] std::string name() const;  ///< "Amersfoort / RD New + NAP height"

private:
    struct Parts;
    explicit CrsToLonLat(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace noonmark
