#include <fmt/format.h>
#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>

#include "core/city/footprints/geos_shapes.h"
#include "core/city/footprints/repair_footprint.h"

namespace noonmark {

namespace {

constexpr double largestCoordinateM =
    1e8;  // twice round the earth: a larger value is an error of unit or field
constexpr std::size_t fewestPoints = 3;

using Geometry = Geos::Geometry;

bool isValid(const Geos& geos, const Geometry& geometry) { return GEOSisValid_r(geos, geometry.get()) == 1; }

// "Self-intersection", without the location that GEOS appends: the same text for the same problem.
std::string reasonOf(const Geos& geos, const Geometry& geometry) {
    char* reason = GEOSisValidReason_r(geos, geometry.get());
    const std::string_view text = reason != nullptr ? reason : "";
    std::string withoutPlace(text.substr(0, text.find('[')));
    GEOSFree_r(geos, reason);
    return withoutPlace;
}

// The outline's interior minus the holes' interiors; a hole wholly outside becomes a piece of its own.
Geometry madeValid(const Geos& geos, const Geometry& geometry) {
    GEOSMakeValidParams* params = GEOSMakeValidParams_create_r(geos);
    GEOSMakeValidParams_setMethod_r(geos, params, GEOS_MAKE_VALID_STRUCTURE);
    GEOSGeometry* valid = GEOSMakeValidWithParams_r(geos, geometry.get(), params);
    GEOSMakeValidParams_destroy_r(geos, params);
    return geos.owned(valid);
}

// Snap rounding: moves all points to multiples of the step and keeps the geometry valid.
Geometry snapToGrid(const Geos& geos, const Geometry& geometry, double stepM) {
    return geos.owned(GEOSGeom_setPrecision_r(geos, geometry.get(), stepM, 0));
}

// --- Rings before they are given to GEOS

bool usable(glm::dvec2 p) {
    return std::abs(p.x) <= largestCoordinateM && std::abs(p.y) <= largestCoordinateM;
}

template <class Points>
Points withoutRepeats(Points ring) {
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

// Copies through a Ring: GCC 12 takes dvec2(vec2(point)) for the point itself.
RawRing roundRing(const RawRing& ring) {
    Ring inFloat;
    for (const glm::dvec2 point : ring) inFloat.emplace_back(point);
    inFloat = withoutRepeats(std::move(inFloat));
    return {inFloat.begin(), inFloat.end()};
}

// Drops holes that are not rings; empty if the outline is not a ring.
std::vector<RawRing> cleanRings(const std::vector<RawRing>& rings, RepairedFootprint& result) {
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

// The smallest step of float32 over all coordinates of the rings, metres: 1 mm at 10 km. At least a
// micrometre.
double floatStep(const std::vector<RawRing>& rings) {
    double largest = 1;
    for (const RawRing& ring : rings)
        for (const glm::dvec2 point : ring)
            largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    constexpr int floatBits = 24;
    return std::ldexp(1.0, std::max(-20, std::ilogb(largest) + 1 - floatBits));
}

std::string describeReason(const std::string& reason) {
    static const std::map<std::string, std::string, std::less<>> words{
        {"Self-intersection", "outline or holes crossed"},
        {"Ring Self-intersection", "outline or a hole touched itself"},
        {"Hole lies outside shell", "a hole lay outside its outline"},
        {"Holes are nested", "a hole lay inside another hole"},
        {"Interior is disconnected", "holes cut the outline into pieces"},
        {"Duplicate Rings", "two rings were identical"},
        {"Too few points in geometry component", "a ring had no interior"},
    };
    const auto found = words.find(reason);
    return found != words.end() ? found->second : "shape was not valid (" + reason + ")";
}

void say(RepairedFootprint& result, const std::string& what) {
    result.what += (result.what.empty() ? "" : ", ") + what;
}

// Valid polygons whose points are all float32; null if GEOS fails.
Geometry repairRings(const Geos& geos, const std::vector<RawRing>& rings, RepairedFootprint& result) {
    auto inFloat = rings;
    for (RawRing& ring : inFloat) ring = roundRing(ring);
    const auto isRing = [](const RawRing& ring) { return ring.size() >= fewestPoints; };
    if (std::all_of(inFloat.begin(), inFloat.end(), isRing)) {
        auto polygon = makePolygonGeometry(geos, inFloat);
        if (polygon && isValid(geos, polygon)) return polygon;
    }
    auto polygon = makePolygonGeometry(geos, rings);
    if (polygon && !isValid(geos, polygon)) {
        say(result, describeReason(reasonOf(geos, polygon)));
        if (areTangled(rings)) {
            say(result, fmt::format("more than {} times; redraw or simplify it", maxCrossings));
            return geos.owned(nullptr);
        }
        polygon = madeValid(geos, polygon);
    }
    return polygon ? snapToGrid(geos, polygon, floatStep(rings)) : std::move(polygon);
}

}  // namespace

RepairedFootprint repairFootprint(const std::vector<RawRing>& rings) {
    RepairedFootprint result;
    const auto good = cleanRings(rings, result);
    if (good.empty()) {
        if (rings.empty()) result.what = "outline had fewer than three points";
        result.kind = WarningKind::dropped;
        return result;
    }
    const Geos geos;
    const auto geometry = repairRings(geos, good, result);
    bool sliver = false;
    result.pieces = toPolygons(geos, geometry, &sliver);
    if (sliver) say(result, "slivers under 0.01 m2 left out");
    if (!result.pieces.empty()) return result;
    if (result.what.empty()) result.what = "outline had no interior";
    result.kind = WarningKind::dropped;
    return result;
}

}  // namespace noonmark
