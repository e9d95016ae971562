#include <geos_c.h>

#include "core/city/footprints/box_index.h"
#include "core/city/footprints/geos_shapes.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/footprints/shared_area.h"

namespace noonmark {

namespace {

using Geometry = Geos::Geometry;

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
                                        const std::vector<Footprint>& others, MinPiece least) {
    if (!others.empty() && boundAreaOutside(footprints, others).maxM2 < least.areaM2 / 2) return {};
    const Geos geos;
    const Geometry whole = uniteGeometry(geos, collection(geos, footprints));
    const Geometry cover = uniteGeometry(geos, collection(geos, others));
    auto pieces = toPolygons(geos, subtractGeometry(geos, whole, cover));
    std::erase_if(pieces, [&](const Footprint& piece) {
        return area(piece) < least.areaM2 || !isWide(geos, piece, least.widthM);
    });
    return pieces;
}

std::vector<Footprint> keepMeeting(const std::vector<Footprint>& footprints, std::vector<Footprint> others) {
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
