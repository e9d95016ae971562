#include <geos_c.h>

#include <algorithm>

#include "core/city/footprints/geos_shapes.h"
#include "core/city/footprints/plan_lines.h"

namespace noonmark {

namespace {

using Geometry = Geos::Geometry;

Geometry polygonize(const Geos& geos, const Geometry& lines) {
    if (!lines) return geos.owned(nullptr);
    const GEOSGeometry* const all[] = {lines.get()};
    return geos.owned(GEOSPolygonize_r(geos, all, 1));
}

bool isInOddRings(const Footprint& face, const std::vector<Footprint>& faces) {
    const glm::dvec2 point = findPointInside(face);
    return std::ranges::count_if(faces,
                                 [&](const Footprint& other) {
                                     return contains({other.outer, {}}, point);
                                 }) %
               2 ==
           1;
}

// Adds a line from the last point of a chain to its first, if they differ.
void addClosingLine(const Geos& geos, const GEOSGeometry* chain, std::vector<PlanLine>& lines) {
    if (GEOSisClosed_r(geos, chain) == 1) return;
    const Geometry first = geos.owned(GEOSGeomGetStartPoint_r(geos, chain)),
                   last = geos.owned(GEOSGeomGetEndPoint_r(geos, chain));
    if (!first || !last) return;
    PlanLine line{};
    GEOSGeomGetX_r(geos, last.get(), &line.a.x);
    GEOSGeomGetY_r(geos, last.get(), &line.a.y);
    GEOSGeomGetX_r(geos, first.get(), &line.b.x);
    GEOSGeomGetY_r(geos, first.get(), &line.b.y);
    lines.push_back(line);
}

}  // namespace

std::vector<Footprint> findFaces(const std::vector<PlanLine>& lines) {
    const Geos geos;
    return toPolygons(geos, polygonize(geos, nodeLines(geos, lines)));
}

std::vector<Footprint> findEnclosedFaces(const std::vector<PlanLine>& lines) {
    const std::vector<Footprint> faces = findFaces(lines);
    std::vector<Footprint> inside;
    for (const Footprint& face : faces)
        if (isInOddRings(face, faces)) inside.push_back(face);
    if (inside.size() < 2) return inside;
    const Geos geos;
    return toPolygons(geos, uniteGeometry(geos, collection(geos, inside)));
}

std::vector<PlanLine> closeChains(const std::vector<PlanLine>& lines) {
    const Geos geos;
    const Geometry noded = nodeLines(geos, lines);
    const Geometry chains = geos.owned(noded ? GEOSLineMerge_r(geos, noded.get()) : nullptr);
    std::vector<PlanLine> closed = lines;
    if (!chains) return closed;
    for (int i = 0; i < GEOSGetNumGeometries_r(geos, chains.get()); ++i)
        addClosingLine(geos, GEOSGetGeometryN_r(geos, chains.get(), i), closed);
    return closed;
}

glm::dvec2 findPointInside(const Footprint& polygon) {
    const Geos geos;
    const Geometry shape = collection(geos, std::vector<Footprint>{polygon});
    const Geometry point = geos.owned(shape ? GEOSPointOnSurface_r(geos, shape.get()) : nullptr);
    glm::dvec2 place(polygon.outer[0]);
    if (point) GEOSGeomGetX_r(geos, point.get(), &place.x), GEOSGeomGetY_r(geos, point.get(), &place.y);
    return place;
}

}  // namespace noonmark
