#include "core/receivers/region.h"

#include <fmt/format.h>

#include <cmath>

#include "core/describe/text.h"

namespace noonmark {

namespace {
constexpr int pointsPerSide = 8;  // parallels are curves in the local plane

void addSide(Ring& ring, const Frame& frame, LonLat from, LonLat to) {
    for (int i = 0; i < pointsPerSide; ++i) {
        const double share = double(i) / pointsPerSide;
        const LonLat place{std::lerp(from.lonDeg, to.lonDeg, share),
                           std::lerp(from.latDeg, to.latDeg, share)};
        ring.emplace_back(frame.localFromLonLat(place));
    }
}
}  // namespace

Result<Region> makeRegionFromLonLatBox(const Frame& frame, double westDeg, double southDeg, double eastDeg,
                                       double northDeg) {
    const std::string box = fmt::format("region {},{},{},{}", westDeg, southDeg, eastDeg, northDeg);
    const bool inRange = std::abs(westDeg) <= 180 && std::abs(eastDeg) <= 180 && std::abs(southDeg) <= 90 &&
                         std::abs(northDeg) <= 90;
    if (!inRange)
        return failure(NM_TEXT("A corner is not on the globe"), box,
                       NM_TEXT("Give degrees: west,south,east,north"));
    // A box whose west is the larger number crosses the antimeridian; one that would span most of the globe
    // has its sides swapped.
    const double lastDeg = eastDeg < westDeg ? eastDeg + 360 : eastDeg;
    if (!(westDeg < lastDeg && lastDeg - westDeg <= 180) || !(southDeg < northDeg))
        return failure(
            NM_TEXT("The box is empty"), box,
            NM_TEXT("Give west < east (or west > east across the 180th meridian) and south < north"));
    Ring ring;
    addSide(ring, frame, {westDeg, southDeg}, {lastDeg, southDeg});
    addSide(ring, frame, {lastDeg, southDeg}, {lastDeg, northDeg});
    addSide(ring, frame, {lastDeg, northDeg}, {westDeg, northDeg});
    addSide(ring, frame, {westDeg, northDeg}, {westDeg, southDeg});
    return Region{"box", {Footprint{std::move(ring), {}}}};
}

Region makeRegionFromLocalBox(const Box2& box) {
    return {"box", {Footprint{{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}, {}}}};
}

Box2 bounds(const Region& region) {
    Box2 box;
    for (const Footprint& polygon : region.polygons) box.add(bounds(polygon));
    return box;
}

}  // namespace noonmark
