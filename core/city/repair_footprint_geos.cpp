// The reentrant interface only: GEOS objects belong to a context, and every call of repairFootprint() has its
// own.
#define GEOS_USE_ONLY_R_API
#include <fmt/format.h>
#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string_view>

#include "core/city/repair_footprint.h"

namespace noonmark {

namespace {

constexpr double smallestAreaM2 = 0.01;
constexpr double largestCoordinateM =
    1e8;  // twice round the earth: beyond it, a unit or a field was mistaken
constexpr std::size_t fewestPoints = 3;

/// Owns a GEOS context and gives out geometries that free themselves. Failures of GEOS come back as null,
/// never as exceptions.
class Geos {
public:
    struct Free {
        GEOSContextHandle_t context;
        void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
        void operator()(char* text) const { GEOSFree_r(context, text); }
    };
    using Geometry = std::unique_ptr<GEOSGeometry, Free>;
    using Text = std::unique_ptr<char, Free>;

    Geos() : context_(GEOS_init_r()) {}
    ~Geos() { GEOS_finish_r(context_); }
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;

    [[nodiscard]] GEOSContextHandle_t context() const { return context_; }
    [[nodiscard]] Geometry own(GEOSGeometry* geometry) const { return {geometry, Free{context_}}; }

    [[nodiscard]] Geometry polygon(const std::vector<RawRing>& rings) const {
        GEOSGeometry* outer = ring(rings.front());
        std::vector<GEOSGeometry*> holes;
        for (std::size_t i = 1; i < rings.size(); ++i) holes.push_back(ring(rings[i]));
        return own(GEOSGeom_createPolygon_r(context_, outer, holes.data(), unsigned(holes.size())));
    }

    [[nodiscard]] bool isValid(const Geometry& geometry) const {
        return GEOSisValid_r(context_, geometry.get()) == 1;
    }

    /// "Self-intersection", without the place that GEOS adds: the same text for the same trouble.
    [[nodiscard]] std::string reasonOf(const Geometry& geometry) const {
        const Text reason{GEOSisValidReason_r(context_, geometry.get()), Free{context_}};
        const std::string_view text = reason ? reason.get() : "";
        return std::string(text.substr(0, text.find('[')));
    }

    /// The outline's inside less the holes' insides; a hole wholly outside becomes a piece of its own.
    [[nodiscard]] Geometry madeValid(const Geometry& geometry) const {
        GEOSMakeValidParams* params = GEOSMakeValidParams_create_r(context_);
        GEOSMakeValidParams_setMethod_r(context_, params, GEOS_MAKE_VALID_STRUCTURE);
        GEOSGeometry* valid = GEOSMakeValidWithParams_r(context_, geometry.get(), params);
        GEOSMakeValidParams_destroy_r(context_, params);
        return own(valid);
    }

    /// Snap rounding: all points on multiples of the step, and still valid.
    [[nodiscard]] Geometry snapped(const Geometry& geometry, double stepM) const {
        return own(GEOSGeom_setPrecision_r(context_, geometry.get(), stepM, 0));
    }

private:
    [[nodiscard]] GEOSGeometry* ring(const RawRing& points) const {
        GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context_, unsigned(points.size() + 1), 2);
        for (unsigned i = 0; i <= points.size(); ++i) {
            const glm::dvec2 point = points[i % points.size()];
            GEOSCoordSeq_setXY_r(context_, sequence, i, point.x, point.y);
        }
        return GEOSGeom_createLinearRing_r(context_, sequence);
    }

    GEOSContextHandle_t context_;
};

// --- Rings before GEOS sees them

bool usable(glm::dvec2 p) {
    return std::abs(p.x) <= largestCoordinateM && std::abs(p.y) <= largestCoordinateM;
}

template <class Points>
Points withoutRepeats(Points ring) {
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

// By way of a Ring of its own: GCC 12 takes dvec2(vec2(point)) for the point itself.
RawRing rounded(const RawRing& ring) {
    Ring inFloat;
    for (const glm::dvec2 point : ring) inFloat.emplace_back(point);
    inFloat = withoutRepeats(std::move(inFloat));
    return {inFloat.begin(), inFloat.end()};
}

// Holes that are no rings at all are left out; an empty answer: the outline is none.
std::vector<RawRing> cleaned(const std::vector<RawRing>& rings, RepairedFootprint& result) {
    std::vector<RawRing> good;
    for (const RawRing& ring : rings) {
        const bool placed = std::all_of(ring.begin(), ring.end(), usable);
        RawRing clean = placed ? withoutRepeats(ring) : RawRing{};
        if (clean.size() >= fewestPoints) {
            good.push_back(std::move(clean));
            continue;
        }
        const bool isOutline = &ring == &rings.front();
        result.what =
            fmt::format("{} had {}", isOutline ? "outline" : "a hole",
                        placed ? "fewer than three points" : "coordinates that are not numbers or too large");
        if (isOutline) return {};
    }
    return good;
}

// The finest step that float32 has for every coordinate of the rings, metres: 1 mm at 10 km. Never under a
// micrometre.
double floatStep(const std::vector<RawRing>& rings) {
    double largest = 1;
    for (const RawRing& ring : rings)
        for (const glm::dvec2 point : ring)
            largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    constexpr int floatBits = 24;
    return std::ldexp(1.0, std::max(-20, std::ilogb(largest) + 1 - floatBits));
}

// --- Pieces out of what GEOS gives back

Ring ringOf(const Geos& geos, const GEOSGeometry* geometry, bool counterClockwise) {
    const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(geos.context(), geometry);
    unsigned count = 0;
    GEOSCoordSeq_getSize_r(geos.context(), sequence, &count);
    Ring ring;
    for (unsigned i = 0; i + 1 < count; ++i) {
        glm::dvec2 point{};
        GEOSCoordSeq_getXY_r(geos.context(), sequence, i, &point.x, &point.y);
        ring.emplace_back(point);
    }
    if ((signedArea(ring) > 0) != counterClockwise) std::reverse(ring.begin(), ring.end());
    return ring;
}

Footprint footprintOf(const Geos& geos, const GEOSGeometry* polygon, bool& sliver) {
    Footprint footprint{ringOf(geos, GEOSGetExteriorRing_r(geos.context(), polygon), true), {}};
    const int holes = GEOSGetNumInteriorRings_r(geos.context(), polygon);
    for (int i = 0; i < holes; ++i) {
        Ring hole = ringOf(geos, GEOSGetInteriorRingN_r(geos.context(), polygon, i), false);
        if (-signedArea(hole) >= smallestAreaM2)
            footprint.holes.push_back(std::move(hole));
        else
            sliver = true;
    }
    return footprint;
}

void collectPieces(const Geos& geos, const GEOSGeometry* geometry, std::vector<Footprint>& pieces,
                   bool& sliver) {
    if (GEOSGeomTypeId_r(geos.context(), geometry) == GEOS_POLYGON) {
        if (GEOSisEmpty_r(geos.context(), geometry) != 0) return;
        Footprint footprint = footprintOf(geos, geometry, sliver);
        if (area(footprint) >= smallestAreaM2)
            pieces.push_back(std::move(footprint));
        else
            sliver = true;
        return;
    }
    if (GEOSGeomTypeId_r(geos.context(), geometry) < GEOS_MULTIPOINT)
        return;  // a point or line has no inside
    for (int i = 0; i < GEOSGetNumGeometries_r(geos.context(), geometry); ++i)
        collectPieces(geos, GEOSGetGeometryN_r(geos.context(), geometry, i), pieces, sliver);
}

std::string inWords(const std::string& reason) {
    static const std::map<std::string, std::string, std::less<>> words{
        {"Self-intersection", "outline or holes crossed"},
        {"Ring Self-intersection", "outline or a hole touched itself"},
        {"Hole lies outside shell", "a hole lay outside its outline"},
        {"Holes are nested", "a hole lay in a hole"},
        {"Interior is disconnected", "holes cut the outline into pieces"},
        {"Duplicate Rings", "two rings were the same"},
        {"Too few points in geometry component", "a ring had no inside"},
    };
    const auto found = words.find(reason);
    return found != words.end() ? found->second : "shape was not valid (" + reason + ")";
}

void say(RepairedFootprint& result, const std::string& what) {
    result.what += (result.what.empty() ? "" : ", ") + what;
}

// Valid polygons whose points are all float32; null where GEOS fails.
Geos::Geometry mended(const Geos& geos, const std::vector<RawRing>& rings, RepairedFootprint& result) {
    auto inFloat = rings;
    for (RawRing& ring : inFloat) ring = rounded(ring);
    const auto isRing = [](const RawRing& ring) { return ring.size() >= fewestPoints; };
    if (std::all_of(inFloat.begin(), inFloat.end(), isRing)) {
        auto polygon = geos.polygon(inFloat);
        if (polygon && geos.isValid(polygon)) return polygon;
    }
    auto polygon = geos.polygon(rings);
    if (polygon && !geos.isValid(polygon)) {
        say(result, inWords(geos.reasonOf(polygon)));
        polygon = geos.madeValid(polygon);
    }
    return polygon ? geos.snapped(polygon, floatStep(rings)) : std::move(polygon);
}

}  // namespace

RepairedFootprint repairFootprint(const std::vector<RawRing>& rings) {
    RepairedFootprint result;
    const auto good = cleaned(rings, result);
    if (good.empty()) {
        if (rings.empty()) result.what = "outline had fewer than three points";
        result.kind = WarningKind::dropped;
        return result;
    }
    const Geos geos;
    const auto geometry = mended(geos, good, result);
    bool sliver = false;
    if (geometry) collectPieces(geos, geometry.get(), result.pieces, sliver);
    if (sliver) say(result, "slivers under 0.01 m2 left out");
    if (!result.pieces.empty()) return result;
    if (result.what.empty()) result.what = "outline had no inside";
    result.kind = WarningKind::dropped;
    return result;
}

}  // namespace noonmark
