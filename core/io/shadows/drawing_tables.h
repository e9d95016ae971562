#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/io/shadows/shadow_drawing.h"
#include "core/io/styles/qgis_style.h"

namespace noonmark {

using DrawingValue = std::variant<std::string, double, Instant>;

struct DrawingColumn {
    std::string name;
    DrawingValue kind;  ///< a value of the column's type
};

/// A feature: polygons or lines, and one value a column.
struct DrawingRow {
    std::vector<Footprint> polygons;
    std::vector<std::vector<glm::vec2>> lines;  ///< closed lines repeat their first point
    std::vector<DrawingValue> values;
};

struct DrawingTable {
    std::string name;
    bool isOfLines = false;
    std::vector<DrawingColumn> columns;
    std::vector<DrawingRow> rows;
    LayerStyle style{};  ///< for QGIS, of what was measured
};

/// The layers of a drawing as tables, those without a row left out, except shadows:
/// - shadows: time, utc, azimuth_deg, altitude_deg, kind (baseline, incremental, gained), area_m2, cell_m (0:
///   exact); one row a moment and kind with shadow
/// - buildings: id, name, state, height_m, bottom_m (above the ground); one row a part
/// - places: name, kind, area_m2
/// - fan: day, time, utc, azimuth_deg, altitude_deg, area_m2; one row a moment
/// - isochrones: day, minutes, closed (1 or 0), cell_m
/// - distances: distance_m
std::vector<DrawingTable> makeDrawingTables(const ShadowDrawing& drawing);

/// The kinds of shadow of a moment, with their names: "baseline", "incremental", "gained".
struct NamedShadow {
    const char* kind;
    const std::vector<Footprint>* polygons;
};
std::vector<NamedShadow> listShadows(const ShadowOutlines& outlines);

/// The points of a line, the first one repeated at the end if it is closed.
std::vector<glm::vec2> pointsToDraw(const Isochrone& line);

}  // namespace noonmark
