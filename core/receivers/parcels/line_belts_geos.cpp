#include <geos_c.h>

#include "core/city/footprints/geos_shapes.h"
#include "core/receivers/parcels/line_belts.h"

namespace noonmark {

Result<std::vector<Footprint>> cutBelt(const std::vector<Footprint>& polygons, double innerM, double outerM) {
    constexpr int chordsPerQuarter = 16;
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

}  // namespace noonmark
