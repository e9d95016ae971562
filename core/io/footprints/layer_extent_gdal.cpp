#include <ogrsf_frmts.h>

#include <memory>

#include "core/io/footprints/layer_extent.h"
#include "core/io/layers/feature_stream.h"

namespace noonmark {

bool isIndexed(OGRLayer& layer) { return layer.TestCapability(OLCFastSpatialFilter) != FALSE; }

bool limitToExtent(OGRLayer& layer, const LonLatBox& box, const ReadSettings& settings) {
    constexpr int pointsOnASide = 21;
    OGRSpatialReference degrees;
    degrees.SetWellKnownGeogCS("WGS84");
    degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const OGRSpatialReference system = findLayerSystem(layer, settings.crs);
    const std::unique_ptr<OGRCoordinateTransformation> there(
        OGRCreateCoordinateTransformation(&degrees, &system));
    if (!there) return false;
    double west = 0, south = 0, east = 0, north = 0;
    if (there->TransformBounds(box.westDeg, box.southDeg, box.eastDeg, box.northDeg, &west, &south, &east,
                               &north, pointsOnASide) == FALSE)
        return false;
    layer.SetSpatialFilterRect(west, south, east, north);
    return true;
}

}  // namespace noonmark
