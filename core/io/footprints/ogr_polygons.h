#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/base/result.h"
#include "core/city/footprints/footprint.h"
#include "core/geo/crs.h"
#include "core/geo/frame.h"

class OGRGeometry;
class OGRSpatialReference;

namespace noonmark {

/// A polygon in the file's own coordinates: the outer ring, then holes.
using CrsPolygon = std::vector<std::vector<glm::dvec2>>;

/// Whether a polygon with elevations stands upright, as the walls of a solid do: it has no area in plan.
bool isUprightFace(const OGRGeometry& face);

/// Every polygon in a geometry, seen from above, including those in collections and curved ones (as straight
/// pieces). Points, lines, empty polygons and the upright faces of solids are skipped. Backend:
/// ogr_polygons_gdal.cpp.
std::vector<CrsPolygon> readPolygons(const OGRGeometry& geometry);

/// Transforms polygons of one coordinate system to local metres. Not thread-safe. Backend:
/// ogr_polygons_gdal.cpp.
class PolygonLayer {
public:
    /// `crs` may be null. `where`: the file, for messages. Error: no system, or an unknown one.
    static Result<PolygonLayer> of(const OGRSpatialReference* crs, const Frame& frame,
                                   const std::string& where);

    /// Every polygon of the geometry, including collections and curves, repaired if invalid; long sides get
    /// extra points, so that they follow the curves of the projection. Error: a point that the system cannot
    /// have, or that is more than 200 km from the frame's origin; a polygon of more than maxOutlinePoints.
    [[nodiscard]] Result<std::vector<Footprint>> polygons(const OGRGeometry& geometry) const;

    /// Whether the geometry may reach into the box, judged by its envelope; much cheaper than polygons().
    /// Never wrongly false for a geometry smaller than 1 km.
    [[nodiscard]] bool mayReach(const OGRGeometry& geometry, const Box2& box) const;

private:
    PolygonLayer(CrsToLonLat toLonLat, double longestSide, const Frame& frame, std::string where);
    using LocalRing = std::vector<glm::dvec2>;
    Result<void> add(const OGRGeometry& geometry, std::vector<Footprint>& pieces) const;
    [[nodiscard]] Result<LocalRing> localRing(const std::vector<glm::dvec2>& points) const;

    CrsToLonLat toLonLat_;
    double longestSide_ = 0;  // in the system's units
    bool inDegrees_ = false;  // longitudes are unwrapped near the frame's before sides are divided
    Frame frame_;
    std::string where_;
};

/// Error for a place more than 200 km from the frame's origin, which no study there can mean.
Result<void> checkedNear(LonLat place, const Frame& frame, const std::string& where);

/// How a polygon of a KML file stands: GDAL's reader has its altitudes, but not what they count from.
enum class KmlStanding {
    onGround,  ///< clampToGround: its altitudes are ignored
    extruded,  ///< its walls reach from the ground to its altitude above the ground
    floating,  ///< at its altitude above the ground, without walls
    absolute,  ///< at its altitude above sea level
};

/// What GDAL's reader leaves out of the polygons of a KML file, by the first corner of their outer ring.
class KmlPolygons {
public:
    using Corner = std::tuple<double, double, double>;  ///< longitude, latitude, altitude
    using Data = std::map<std::string, std::string>;    ///< fields of a placemark (ExtendedData)

    /// Nothing for a file that is not XML or larger than 256 MiB. Reads the whole file; memory some ten times
    /// its size. Backend: ogr_polygons_gdal.cpp.
    static KmlPolygons of(const std::filesystem::path& file);

    /// Of the geometry's first polygon; nothing where it has none.
    static std::optional<Corner> firstCornerOf(const OGRGeometry& geometry);
    [[nodiscard]] std::optional<KmlStanding> findStanding(const Corner& firstCorner) const;
    /// Null where its placemark has none.
    [[nodiscard]] const Data* findData(const Corner& firstCorner) const;
    /// The fields of all placemarks, at most 200.
    [[nodiscard]] const std::set<std::string>& fields() const { return fields_; }

private:
    friend class KmlCollector;
    std::map<Corner, KmlStanding> standing_;
    std::map<Corner, std::shared_ptr<const Data>> data_;
    std::set<std::string> fields_;
};

}  // namespace noonmark
