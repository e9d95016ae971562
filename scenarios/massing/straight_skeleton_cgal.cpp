#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/create_offset_polygons_2.h>
#include <CGAL/create_straight_skeleton_from_polygon_with_holes_2.h>

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "core/city/footprints/repair_footprint.h"
#include "scenarios/massing/straight_skeleton.h"

namespace noonmark {

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;
using CgalSkeleton = CGAL::Straight_skeleton_2<Kernel>;

Polygon polygonOf(const Ring& ring) {
    Polygon polygon;
    for (const glm::vec2 point : ring) polygon.push_back({double(point.x), double(point.y)});
    return polygon;
}

// Call only for simple rings: others have no orientation.
void orient(PolygonWithHoles& polygon) {
    if (polygon.outer_boundary().is_clockwise_oriented()) polygon.outer_boundary().reverse_orientation();
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
        if (hole->is_counterclockwise_oriented()) hole->reverse_orientation();
}

RawRing parseRing(const Polygon& polygon) {
    RawRing ring;
    for (const auto& point : polygon.vertices()) ring.emplace_back(point.x(), point.y());
    return ring;
}

bool touch(const Polygon& a, const Polygon& b) {
    return std::any_of(a.edges_begin(), a.edges_end(), [&](const auto& edge) {
        return std::any_of(b.edges_begin(), b.edges_end(),
                           [&](const auto& other) { return CGAL::do_intersect(edge, other); });
    });
}

// CGAL does not terminate on rings that touch.
bool isSimple(const PolygonWithHoles& polygon) {
    const auto& outer = polygon.outer_boundary();
    if (!outer.is_simple()) return false;
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) {
        if (!hole->is_simple() || touch(*hole, outer) || outer.has_on_unbounded_side((*hole)[0]))
            return false;
        for (auto other = polygon.holes_begin(); other != hole; ++other)
            if (touch(*hole, *other)) return false;
    }
    return true;
}

bool hasRings(const Footprint& footprint) {
    const auto isRing = [](const Ring& ring) { return ring.size() >= 3; };
    return isRing(footprint.outer) && std::ranges::all_of(footprint.holes, isRing);
}

std::size_t pointsOf(const Footprint& footprint) {
    std::size_t points = footprint.outer.size();
    for (const Ring& hole : footprint.holes) points += hole.size();
    return points;
}

tl::unexpected<Error> notSimple() {
    return failure("The outline cannot be inset: it crosses or touches itself, or its courtyards touch",
                   "massing", "Draw the lot as a simple polygon, its courtyards inside");
}
}  // namespace

struct StraightSkeleton::Skeleton {
    Footprint outline;
    boost::shared_ptr<CgalSkeleton> cgal;
};

StraightSkeleton::StraightSkeleton(std::unique_ptr<Skeleton> skeleton, double deepestM)
    : skeleton_(std::move(skeleton)), deepestM_(deepestM) {}
StraightSkeleton::StraightSkeleton(StraightSkeleton&&) noexcept = default;
StraightSkeleton& StraightSkeleton::operator=(StraightSkeleton&&) noexcept = default;
StraightSkeleton::~StraightSkeleton() = default;

Result<StraightSkeleton> StraightSkeleton::of(const Footprint& footprint) try {
    if (pointsOf(footprint) > maxPoints)
        return failure(fmt::format("The outline has {} points", pointsOf(footprint)), "massing",
                       fmt::format("Draw it with {} or fewer", maxPoints));
    if (!hasRings(footprint)) return notSimple();
    PolygonWithHoles polygon(polygonOf(footprint.outer));
    for (const Ring& hole : footprint.holes) polygon.add_hole(polygonOf(hole));
    if (!isSimple(polygon)) return notSimple();
    orient(polygon);
    auto skeleton = std::make_unique<Skeleton>();
    skeleton->outline = footprint;
    skeleton->cgal = CGAL::create_interior_straight_skeleton_2(polygon, Kernel());
    if (!skeleton->cgal) return notSimple();
    double deepest = 0;
    for (auto vertex = skeleton->cgal->vertices_begin(); vertex != skeleton->cgal->vertices_end(); ++vertex)
        deepest = std::max(deepest, CGAL::to_double(vertex->time()));
    return StraightSkeleton(std::move(skeleton), deepest);
} catch (const std::exception&) {
    return notSimple();
}

std::vector<Footprint> StraightSkeleton::inset(double distanceM) const try {
    if (!(distanceM > 0)) return {skeleton_->outline};
    if (distanceM >= deepestM_) return {};
    const auto rings = CGAL::create_offset_polygons_2<Polygon>(distanceM, *skeleton_->cgal);
    // CGAL returns outlines counter-clockwise and holes clockwise; each hole goes to the outline that
    // contains it.
    std::vector<std::vector<RawRing>> polygons;
    for (const auto& ring : rings)
        if (ring->is_counterclockwise_oriented()) polygons.push_back({parseRing(*ring)});
    for (const auto& ring : rings) {
        if (ring->is_counterclockwise_oriented()) continue;
        for (auto& polygon : polygons) {
            Polygon outline;
            for (const glm::dvec2 point : polygon.front()) outline.push_back({point.x, point.y});
            if (outline.has_on_unbounded_side(*ring->vertices_begin())) continue;
            polygon.push_back(parseRing(*ring));
            break;
        }
    }
    std::vector<Footprint> pieces;
    for (const auto& polygon : polygons)
        for (Footprint& piece : repairFootprint(polygon).pieces) pieces.push_back(std::move(piece));
    return pieces;
} catch (const std::exception&) {
    return {};
}

}  // namespace noonmark
