#include <geos_c.h>

#include "core/city/footprints/geos_shapes.h"
#include "core/receivers/parcels/line_belts.h"

namespace noonmark {

namespace {

constexpr int chordsPerQuarter = 16;

}  // namespace

Result<std::vector<Footprint>> cutBelt(const std::vector<Footprint>& polygons, double innerM, double outerM) {
    const Geos geos;
    const Geos::Geometry all = uniteGeometry(geos, collection(geos, polygons));
    if (!all) return failure("The polygons cannot be joined", "parcel", "Draw the parcel again");
    const auto grown = [&](double byM) {
        return geos.owned(GEOSBuffer_r(geos, all.get(), byM, chordsPerQuarter));
    };
    const Geos::Geometry belt = subtractGeometry(geos, grown(outerM), grown(innerM));
    if (!belt)
        return failure("The lines around the polygons cannot be made", "parcel", "Draw the parcel again");
    return toPolygons(geos, belt);
}

Result<std::vector<Ring>> drawLines(const std::vector<Footprint>& polygons, double offsetM) {
    const Geos geos;
    const Geos::Geometry all = uniteGeometry(geos, collection(geos, polygons));
    if (!all) return failure("The polygons cannot be joined", "parcel", "Draw the parcel again");
    const Geos::Geometry grown = geos.owned(GEOSBuffer_r(geos, all.get(), offsetM, chordsPerQuarter));
    if (!grown)
        return failure("The lines around the polygons cannot be made", "parcel", "Draw the parcel again");
    std::vector<Ring> rings;
    for (const Footprint& polygon : toPolygons(geos, grown)) {
        rings.push_back(polygon.outer);
        rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
    }
    return rings;
}

}  // namespace noonmark
