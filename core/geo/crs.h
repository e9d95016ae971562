#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"

class OGRSpatialReference;

namespace noonmark {

/// Reads the definition of a coordinate reference system, which comes from a file or from the user: a code
/// ("EPSG:7415", "urn:ogc:def:crs:EPSG::7415", "https://www.opengis.net/def/crs/EPSG/0/7415"), WKT, PROJJSON
/// or PROJ text of up to 64 KiB. Points are in the order easting, northing or longitude, latitude. Nothing is
/// fetched and no file is opened but PROJ's own. Error: the system is unknown, not one of the earth's
/// surface, or names a file. Backend: crs_gdal.cpp.
Result<OGRSpatialReference> parseCrs(const std::string& text);

/// Error: the definition names a file (of parameters, or a grid) that is not one of PROJ's own. Without it
/// the system would give other places than its author meant.
Result<void> checkNamesNoFile(std::string_view definition);

/// A system that GDAL has read from a file, as WKT, for parseCrs(). Empty if there is none.
std::string wktOf(const OGRSpatialReference* system);

/// Transforms points of a coordinate reference system to longitude and latitude on WGS84. Horizontal only:
/// the heights of a compound system are left unchanged. Not thread-safe. Backend: crs_gdal.cpp.
class CrsToLonLat {
public:
    /// Accepts what parseCrs() does, with its errors.
    static Result<CrsToLonLat> of(const std::string& crs);

    CrsToLonLat(CrsToLonLat&&) noexcept;
    CrsToLonLat& operator=(CrsToLonLat&&) noexcept;
    ~CrsToLonLat();

    /// Points are given as easting or longitude first, then northing or latitude, whatever axis order the
    /// system's authority defines. NaN for points that are NaN or cannot be transformed, and for what is left
    /// after a stop request to this thread's StopScope. O(points), about 1
    /// us each.
    [[nodiscard]] std::vector<LonLat> lonLat(std::span<const glm::dvec2> points) const;

    /// From now on eastings of UTM that begin with the number of their zone (33 391 800, as German surveys
    /// write them) are read without it. The caller warns (zoneNumberRemoved) if hasRemovedZoneNumber().
    void removeZoneNumber();
    [[nodiscard]] bool hasRemovedZoneNumber() const;

    /// Whether a place is plausible for this system: within 5 degrees of its area of use; true if that area
    /// is unknown.
    [[nodiscard]] bool isPlausible(LonLat place) const;

    /// Metres per unit of elevation, from the vertical part of the system. Without a vertical part,
    /// `elevationUnitIsStated` is false and the unit is the horizontal one if that is a length, else 1 m.
    [[nodiscard]] double metresPerElevationUnit() const;
    [[nodiscard]] bool elevationUnitIsStated() const;

    /// Metres per unit of easting and northing; nothing where they are degrees.
    [[nodiscard]] std::optional<double> metresPerUnit() const;

    [[nodiscard]] std::string name() const;  ///< "Amersfoort / RD New + NAP height"

private:
    struct Parts;
    explicit CrsToLonLat(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace noonmark
