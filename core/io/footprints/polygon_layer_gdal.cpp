#include "core/io/footprints/polygon_layer.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <array>
#include <cmath>
#include <memory>

#include "core/city/footprints/repair_footprint.h"
#include "core/geo/crs_definition.h"
#include "core/geo/distance.h"
#include "core/geo/longitude.h"

namespace noonmark {

namespace {

constexpr double farthestM = 200000;
constexpr double longestSideM = 500;  // a straight side of this length deviates by some 5 mm at most
constexpr double metresPerDegree = 111320;

std::vector<glm::dvec2> pointsOf(const OGRLinearRing& ring) {
    std::vector<glm::dvec2> points;
    for (const OGRPoint& point : ring) points.emplace_back(point.getX(), point.getY());
    return points;
}

std::size_t countPoints(const OGRPolygon& polygon) {
    std::size_t points = 0;
    for (const OGRLinearRing* ring : polygon) points += std::size_t(ring->getNumPoints());
    return points;
}

// Unwraps longitudes, so that no side goes round the globe where a ring crosses the antimeridian.
void unwrap(OGRPolygon& polygon, double nearDeg) {
    for (OGRLinearRing* ring : polygon)
        for (int i = 0; i < ring->getNumPoints(); ++i)
            if (std::abs(ring->getX(i)) <= 360)  // otherwise it is not a longitude, which is reported later
                ring->setPoint(i, wrapLongitudeNear(ring->getX(i), nearDeg), ring->getY(i));
}

bool isInDegrees(const OGRSpatialReference& crs) {
    constexpr double degree = 0.017453292519943295;
    return crs.IsGeographic() != 0 && std::abs(crs.GetAngularUnits() / degree - 1) < 1e-9;
}

}  // namespace

Result<void> checkedNear(LonLat place, const Frame& frame, const std::string& where) {
    const double metres = computeGreatCircleM(place, frame.origin());
    if (metres <= farthestM) return {};
    return failure(fmt::format("The position is {:.0f} km from the city", metres / 1000), where,
                   "Check the order of the numbers (west,south,east,north) and the CRS of the file");
}

PolygonLayer::PolygonLayer(CrsToLonLat toLonLat, double longestSide, const Frame& frame, std::string where)
    : toLonLat_(std::move(toLonLat)), longestSide_(longestSide), frame_(frame), where_(std::move(where)) {}

Result<PolygonLayer> PolygonLayer::of(const OGRSpatialReference* crs, const Frame& frame,
                                      const std::string& where) {
    const std::string wkt = wktOf(crs);
    if (wkt.empty())
        return failure("The file does not state its coordinate reference system", where,
                       "Save it with its CRS, or as GeoJSON");
    auto toLonLat = CrsToLonLat::of(wkt);
    if (!toLonLat) return tl::make_unexpected(Error{toLonLat.error().what, where, toLonLat.error().advice});
    const double metresPerUnit = crs->IsGeographic() != 0 ? metresPerDegree : crs->GetLinearUnits();
    PolygonLayer layer(*std::move(toLonLat), longestSideM / metresPerUnit, frame, where);
    layer.inDegrees_ = isInDegrees(*crs);
    return layer;
}

Result<std::vector<Footprint>> PolygonLayer::polygons(const OGRGeometry& geometry) const {
    std::vector<Footprint> pieces;
    return add(geometry, pieces).map([&] { return std::move(pieces); });
}

Result<void> PolygonLayer::add(const OGRGeometry& geometry, std::vector<Footprint>& pieces) const {
    const std::unique_ptr<OGRGeometry> straight(geometry.getLinearGeometry());
    const OGRwkbGeometryType type = wkbFlatten(straight->getGeometryType());
    if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
        for (const OGRGeometry* member : *straight->toGeometryCollection())
            if (auto added = add(*member, pieces); !added) return added;
        return {};
    }
    if (type != wkbPolygon) return {};
    OGRPolygon& polygon = *straight->toPolygon();
    if (const std::size_t points = countPoints(polygon); points > maxOutlinePoints)
        return limitReached(fmt::format("A polygon has {} points, more than {}", points, maxOutlinePoints),
                            where_, "Simplify it");
    if (inDegrees_) unwrap(polygon, frame_.origin().lonDeg);
    // Checked before its sides are divided: a distant point would give millions of pieces.
    for (const OGRLinearRing* ring : polygon)
        if (const auto near = localRing(pointsOf(*ring)); !near) return tl::make_unexpected(near.error());
    polygon.segmentize(longestSide_);
    std::vector<RawRing> rings;
    for (const OGRLinearRing* ring : polygon) {
        auto local = localRing(pointsOf(*ring));
        if (!local) return tl::make_unexpected(local.error());
        rings.push_back(*std::move(local));
    }
    for (Footprint& piece : repairFootprint(rings).pieces) pieces.push_back(std::move(piece));
    return {};
}

Result<PolygonLayer::LocalRing> PolygonLayer::localRing(const std::vector<glm::dvec2>& points) const {
    const std::vector<LonLat> places = toLonLat_.lonLat(points);
    LocalRing local;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (std::isnan(places[i].lonDeg) || !toLonLat_.isPlausible(places[i]))
            return failure(fmt::format("A point at {}, {} is outside the range of {}", points[i].x,
                                       points[i].y, toLonLat_.name()),
                           where_, "Check the CRS of the file");
        if (auto near = checkedNear(places[i], frame_, where_); !near)
            return tl::make_unexpected(near.error());
        local.push_back(frame_.localFromLonLat(places[i]));
    }
    return local;
}

bool PolygonLayer::mayReach(const OGRGeometry& geometry, const Box2& box) const {
    constexpr float marginM = 1;  // sides deviate by less within 1 km
    OGREnvelope envelope;
    geometry.getEnvelope(&envelope);
    const std::array corners{
        glm::dvec2{envelope.MinX, envelope.MinY}, glm::dvec2{envelope.MaxX, envelope.MinY},
        glm::dvec2{envelope.MaxX, envelope.MaxY}, glm::dvec2{envelope.MinX, envelope.MaxY}};
    Box2 reached;
    for (const LonLat place : toLonLat_.lonLat(corners)) {
        if (std::isnan(place.lonDeg) || computeGreatCircleM(place, frame_.origin()) > farthestM) return false;
        reached.add(glm::vec2(frame_.localFromLonLat(place)));
    }
    return reached.low.x - marginM < box.high.x && box.low.x < reached.high.x + marginM &&
           reached.low.y - marginM < box.high.y && box.low.y < reached.high.y + marginM;
}

}  // namespace noonmark
