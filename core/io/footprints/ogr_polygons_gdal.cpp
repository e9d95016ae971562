#include <ogr_geometry.h>

#include <memory>

#include "core/io/footprints/ogr_polygons.h"

namespace noonmark {

namespace {

std::vector<glm::dvec2> pointsOf(const OGRLinearRing& ring) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < ring.getNumPoints(); ++i) points.emplace_back(ring.getX(i), ring.getY(i));
    return points;
}

void collect(const OGRPolygon& polygon, std::vector<CrsPolygon>& polygons) {
    const OGRLinearRing* outer = polygon.getExteriorRing();
    if (outer == nullptr || outer->getNumPoints() == 0) return;
    CrsPolygon& rings = polygons.emplace_back();
    rings.push_back(pointsOf(*outer));
    for (int i = 0; i < polygon.getNumInteriorRings(); ++i)
        if (polygon.getInteriorRing(i)->getNumPoints() > 0)
            rings.push_back(pointsOf(*polygon.getInteriorRing(i)));
}

void collect(const OGRGeometry& geometry, std::vector<CrsPolygon>& polygons) {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (type == wkbPolygon || type == wkbTriangle)
        collect(*geometry.toPolygon(), polygons);
    else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection))
        for (const OGRGeometry* part : *geometry.toGeometryCollection()) collect(*part, polygons);
    else if (OGR_GT_IsSubClassOf(type, wkbPolyhedralSurface))
        for (const OGRGeometry* face : *geometry.toPolyhedralSurface()) collect(*face, polygons);
}

}  // namespace

std::vector<CrsPolygon> readPolygons(const OGRGeometry& geometry) {
    std::vector<CrsPolygon> polygons;
    if (geometry.hasCurveGeometry() != FALSE) {
        const std::unique_ptr<OGRGeometry> straight(geometry.getLinearGeometry());
        if (straight) collect(*straight, polygons);
    } else {
        collect(geometry, polygons);
    }
    return polygons;
}

}  // namespace noonmark
