#include "core/city/footprints/plan_overlay.h"

#include <geos_c.h>
#include <algorithm>
#include <tuple>

#include "core/city/footprints/geos_shapes.h"
#include "core/city/footprints/plan_areas.h"

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

namespace {

Geos::Geometry makeRectangle(const Geos& geos, const Box2& box) {
    return geos.owned(GEOSGeom_createRectangle_r(geos, double(box.low.x), double(box.low.y),
                                                 double(box.high.x), double(box.high.y)));
}

}  // namespace

// GEOS's tree keeps the addresses of rectangles and of positions, so both stay where they are.
struct BoxIndex::Tree {
    Geos geos;
    GEOSSTRtree* tree = GEOSSTRtree_create_r(geos, 10);
    std::vector<Geos::Geometry> rectangles;
    std::vector<std::size_t> positions;

    explicit Tree(const std::vector<Box2>& boxes) {
        positions.reserve(boxes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (boxes[i].empty()) continue;
            positions.push_back(i);
            rectangles.push_back(makeRectangle(geos, boxes[i]));
            GEOSSTRtree_insert_r(geos, tree, rectangles.back().get(), &positions.back());
        }
    }
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;
    ~Tree() { GEOSSTRtree_destroy_r(geos, tree); }
};

BoxIndex::BoxIndex(const std::vector<Box2>& boxes) : tree_(std::make_unique<Tree>(boxes)) {
    std::ignore = findMeeting({{0, 0}, {0, 0}});  // GEOS builds the tree at the first query
}

BoxIndex::~BoxIndex() = default;
BoxIndex::BoxIndex(BoxIndex&&) noexcept = default;
BoxIndex& BoxIndex::operator=(BoxIndex&&) noexcept = default;

std::vector<std::size_t> BoxIndex::findMeeting(const Box2& box) const {
    std::vector<std::size_t> found;
    if (box.empty()) return found;
    const auto keep = [](void* item, void* list) {
        static_cast<std::vector<std::size_t>*>(list)->push_back(*static_cast<std::size_t*>(item));
    };
    GEOSSTRtree_query_r(tree_->geos, tree_->tree, makeRectangle(tree_->geos, box).get(), keep, &found);
    std::ranges::sort(found);
    return found;
}

namespace {

// Whether anything is left after the footprint was eroded by half of `widthM`.
bool isWide(const Geos& geos, const Footprint& footprint, double widthM) {
    const Geometry whole = collection(geos, std::vector<Footprint>{footprint});
    if (!whole) return false;
    const Geometry core = geos.owned(GEOSBuffer_r(geos, whole.get(), -widthM / 2, 2));
    return core && GEOSisEmpty_r(geos, core.get()) == 0;
}

// Null if GEOS fails even on a grid of 1 mm.
Geometry sharedGeometry(const Geos& geos, const std::vector<Footprint>& a, const std::vector<Footprint>& b) {
    const Geometry first = collection(geos, a);
    const Geometry second = collection(geos, b);
    if (!first || !second) return geos.owned(nullptr);
    Geometry quick = geos.owned(GEOSIntersection_r(geos, first.get(), second.get()));
    return quick ? std::move(quick)
                 : geos.owned(GEOSIntersectionPrec_r(geos, first.get(), second.get(), overlayGridM));
}

}  // namespace

std::vector<Footprint> cutPiecesOutside(const std::vector<Footprint>& footprints,
                                        const std::vector<Footprint>& others, MinPiece minimum) {
    if (!others.empty() && boundAreaOutside(footprints, others).maxM2 < minimum.areaM2 / 2) return {};
    const Geos geos;
    const Geometry whole = uniteGeometry(geos, collection(geos, footprints));
    const Geometry cover = uniteGeometry(geos, collection(geos, others));
    auto pieces = toPolygons(geos, subtractGeometry(geos, whole, cover));
    std::erase_if(pieces, [&](const Footprint& piece) {
        return area(piece) < minimum.areaM2 || !isWide(geos, piece, minimum.widthM);
    });
    return pieces;
}

std::vector<Footprint> selectMeeting(const std::vector<Footprint>& footprints,
                                     std::vector<Footprint> others) {
    const Geos geos;
    const Geometry whole = collection(geos, footprints);
    const GEOSPreparedGeometry* prepared = whole ? GEOSPrepare_r(geos, whole.get()) : nullptr;
    if (prepared == nullptr) return others;
    std::erase_if(others, [&](const Footprint& other) {
        const Geometry one = collection(geos, std::vector<Footprint>{other});
        return one && GEOSPreparedIntersects_r(geos, prepared, one.get()) == 0;
    });
    GEOSPreparedGeom_destroy_r(geos, prepared);
    return others;
}

std::vector<Footprint> cutSharedPieces(const std::vector<Footprint>& a, const std::vector<Footprint>& b) {
    const Geos geos;
    return toPolygons(geos, sharedGeometry(geos, a, b));
}

std::vector<Footprint> unitePolygons(const std::vector<Footprint>& polygons) {
    const Geos geos;
    return toPolygons(geos, uniteGeometry(geos, collection(geos, polygons)));
}

double computeSharedArea(const std::vector<Footprint>& a, const std::vector<Footprint>& b) {
    constexpr std::size_t maxPairs = 1'000'000;
    if (countPoints(a) * countPoints(b) > maxPairs) {
        const Geos geos;
        return computeArea(geos, sharedGeometry(geos, a, b));
    }
    double sum = 0;
    for (const Footprint& one : a)
        for (const Footprint& other : b) sum += computeSharedArea(one, other);
    return sum;
}

double computeShareBeside(const std::vector<Footprint>& outline, const std::vector<Footprint>& others,
                          double besideM) {
    const Geos geos;
    const Geometry whole = collection(geos, outline), cover = collection(geos, others);
    const Geometry edges = geos.owned(whole ? GEOSBoundary_r(geos, whole.get()) : nullptr);
    const Geometry near = geos.owned(cover ? GEOSBuffer_r(geos, cover.get(), besideM, 2) : nullptr);
    const Geometry shared =
        geos.owned(edges && near ? GEOSIntersection_r(geos, edges.get(), near.get()) : nullptr);
    double sharedM = 0, wholeM = 0;
    if (shared) GEOSLength_r(geos, shared.get(), &sharedM);
    if (edges) GEOSLength_r(geos, edges.get(), &wholeM);
    return wholeM > 0 ? sharedM / wholeM : 0;
}

std::vector<std::pair<std::size_t, std::size_t>> findMeetingBoxes(const std::vector<Box2>& a,
                                                                  const std::vector<Box2>& b) {
    const BoxIndex index(b);
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (const std::size_t j : index.findMeeting(a[i])) pairs.emplace_back(i, j);
    return pairs;
}

}  // namespace noonmark
