#include "core/io/places/place_assembly.h"

#include <geos_c.h>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/city/footprints/geos_shapes.h"
#include "core/city/meshes/mesh_outline.h"

namespace noonmark {

namespace {

constexpr int segmentsPerQuarter = 4;
constexpr double mitreLimit = 5;

GEOSGeometry* lineGeometry(const Geos& geos, const std::vector<glm::dvec2>& points) {
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(geos, unsigned(points.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i)
        GEOSCoordSeq_setXY_r(geos, sequence, unsigned(i), points[i].x, points[i].y);
    return GEOSGeom_createLineString_r(geos, sequence);
}

std::vector<glm::dvec2> withoutRepeats(const std::vector<glm::dvec2>& points) {
    std::vector<glm::dvec2> kept;
    for (const glm::dvec2 point : points)
        if (std::isfinite(point.x) && std::isfinite(point.y) && (kept.empty() || kept.back() != point))
            kept.push_back(point);
    return kept;
}

// Lines of one width, end to end where they meet, so that bends between two of them are rounded.
void widen(const Geos& geos, std::vector<GEOSGeometry*> lines, double widthM,
           std::vector<Footprint>& polygons) {
    const Geos::Geometry all = geos.owned(
        GEOSGeom_createCollection_r(geos, GEOS_MULTILINESTRING, lines.data(), unsigned(lines.size())));
    if (!all) return;
    Geos::Geometry merged = geos.owned(GEOSLineMerge_r(geos, all.get()));
    const Geos::Geometry wide = geos.owned(
        GEOSBufferWithStyle_r(geos, merged ? merged.get() : all.get(), widthM / 2, segmentsPerQuarter,
                              GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_ROUND, mitreLimit));
    for (Footprint& polygon : toPolygons(geos, wide)) polygons.push_back(std::move(polygon));
}

}  // namespace

std::vector<Footprint> uniteOverlapping(std::vector<Footprint> polygons) {
    if (polygons.size() < 2) return polygons;
    auto joined = computeUnion(polygons);
    return joined.empty() ? polygons : joined;
}

std::vector<Footprint> widenStreet(const std::vector<StreetLine>& lines) {
    const Geos geos;
    std::map<double, std::vector<GEOSGeometry*>> byWidth;
    for (const StreetLine& line : lines)
        if (const auto points = withoutRepeats(line.points); points.size() > 1)
            if (GEOSGeometry* made = lineGeometry(geos, points)) byWidth[line.widthM].push_back(made);
    std::vector<Footprint> polygons;
    for (auto& [widthM, some] : byWidth) widen(geos, std::move(some), widthM, polygons);
    return uniteOverlapping(std::move(polygons));
}

}  // namespace noonmark
