#include <geos_c.h>

#include <algorithm>

#include "core/city/footprints/geos_shapes.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/footprints/shared_area.h"

namespace noonmark {

namespace {

using Geometry = Geos::Geometry;
using Boxes = std::vector<Box2>;

// Whether anything is left after the footprint was eroded by half of `widthM`.
bool isWide(const Geos& geos, const Footprint& footprint, double widthM) {
    const Geometry whole = collection(geos, std::vector<Footprint>{footprint});
    if (!whole) return false;
    const Geometry core = geos.owned(GEOSBuffer_r(geos, whole.get(), -widthM / 2, 2));
    return core && GEOSisEmpty_r(geos, core.get()) == 0;
}

GEOSGeometry* boxGeometry(const Geos& geos, const Box2& box) {
    return GEOSGeom_createRectangle_r(geos, double(box.low.x), double(box.low.y), double(box.high.x),
                                      double(box.high.y));
}

// GEOS's spatial index of boxes; an item is the address of a box in `boxes`.
class BoxTree {
public:
    BoxTree(const Geos& geos, const Boxes& boxes) : geos_(geos), tree_(GEOSSTRtree_create_r(geos, 10)) {
        for (const Box2& box : boxes) {
            if (box.empty()) continue;
            shapes_.push_back(geos.owned(boxGeometry(geos, box)));
            GEOSSTRtree_insert_r(geos, tree_, shapes_.back().get(), const_cast<Box2*>(&box));
        }
    }
    BoxTree(const BoxTree&) = delete;
    BoxTree& operator=(const BoxTree&) = delete;
    ~BoxTree() { GEOSSTRtree_destroy_r(geos_, tree_); }

    [[nodiscard]] std::vector<const Box2*> meeting(const Box2& box) const {
        std::vector<const Box2*> found;
        const Geometry shape = geos_.owned(boxGeometry(geos_, box));
        const auto keep = [](void* item, void* list) {
            static_cast<std::vector<const Box2*>*>(list)->push_back(static_cast<const Box2*>(item));
        };
        GEOSSTRtree_query_r(geos_, tree_, shape.get(), keep, &found);
        return found;
    }

private:
    const Geos& geos_;
    GEOSSTRtree* tree_;
    std::vector<Geometry> shapes_;
};

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
                                        const std::vector<Footprint>& others, LeastPiece least) {
    if (!others.empty() && boundAreaOutside(footprints, others).mostM2 < least.areaM2 / 2) return {};
    const Geos geos;
    const Geometry whole = uniteGeometry(geos, collection(geos, footprints));
    const Geometry cover = uniteGeometry(geos, collection(geos, others));
    auto pieces = toPolygons(geos, subtractGeometry(geos, whole, cover));
    std::erase_if(pieces, [&](const Footprint& piece) {
        return area(piece) < least.areaM2 || !isWide(geos, piece, least.widthM);
    });
    return pieces;
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
    constexpr std::size_t mostPairs = 1'000'000;
    if (countPoints(a) * countPoints(b) > mostPairs) {
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

std::vector<std::pair<std::size_t, std::size_t>> findMeetingBoxes(const Boxes& a, const Boxes& b) {
    const Geos geos;
    const BoxTree tree(geos, b);
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].empty()) continue;
        for (const Box2* box : tree.meeting(a[i])) pairs.emplace_back(i, std::size_t(box - b.data()));
    }
    std::ranges::sort(pairs);
    return pairs;
}

}  // namespace noonmark
