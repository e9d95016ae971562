#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/io/shadows/shadow_drawing.h"

namespace noonmark {

/// Gives names that DXF takes and that differ whatever the case of their letters: letters, digits, hyphens,
/// points and underscores of ASCII, 1 to 200 of them; anything else becomes an underscore. "Größe: 1" is
/// "Gr__e__1", and a second one "Gr__e__1_2".
class LayerNames {
public:
    std::string add(std::string_view wanted);

private:
    std::set<std::string> taken_;  // in lower case
};

/// The plane of DXF and GeoPackage files; metres.
enum class DrawingPlane {
    local,  ///< transverse Mercator whose origin (0, 0) and scale 1 are at the frame's origin, on WGS84:
            ///< areas are true to 1 in 10 million within 2 km
    utm,    ///< the UTM zone of the frame's origin, on WGS84: scale 0.9996 to 1.001
};

/// The plane in words: "Transverse Mercator on WGS84, origin (0, 0) at 40.7475 N ..., metres", or
/// "EPSG:32618, WGS 84 / UTM zone 18N". Error: there is no UTM zone at the frame's origin.
Result<std::string> describePlane(const Frame& frame, DrawingPlane plane);

// Each writer creates `file`, replacing what is there; write through OutputFolder. Errors state what GDAL
// reports, and that there is no UTM zone.

/// Layers, with names that every CAD program takes (LayerNames): `TIME_KIND` for each moment's shadows
/// ("2026-03-21_0900_incremental"), `fan_TIME` and `fan_DAY` (the union), `isochrones_DAY_MINUTES`,
/// `distance_Mm`, `buildings`, `buildings_proposed`, `buildings_removed`, `places`, `place_names`, `area`,
/// and `notes`, which states the plane, the area and the drawing's notes as text south of the area. Shadows
/// are hatches with closed polylines around them, everything else closed polylines; units are metres.
/// Backend: write_shadows_dxf_gdal.cpp.
Result<void> writeShadowsDxf(const std::filesystem::path& file, const ShadowDrawing& drawing,
                             DrawingPlane plane);

/// The layers of makeDrawingTables(). Backend of both: ogr_drawing_gdal.cpp.
Result<void> writeShadowsGeoPackage(const std::filesystem::path& file, const ShadowDrawing& drawing,
                                    DrawingPlane plane);

/// One of these layers ("shadows"), since a GeoJSON file holds only one; longitude and latitude on WGS84.
/// Error: the drawing has no such layer.
Result<void> writeShadowsGeoJson(const std::filesystem::path& file, const ShadowDrawing& drawing,
                                 const std::string& layer);

/// One moment as SVG at 1:`scale`, 1 unit = 1 mm on paper, north up: groups for shadows, buildings and
/// places, with their names as titles, and a line of text with the time, the sun and the scale. UTF-8.
std::string drawShadowsSvg(const ShadowDrawing& drawing, const DrawnMoment& moment, double scale);

}  // namespace noonmark
