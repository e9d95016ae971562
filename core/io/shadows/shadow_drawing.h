#pragma once

// The folder core/io/shadows writes outlines of shadows for other programs. ShadowDrawing (this file) is
// everything that is written; write_shadows.h writes it as DXF, GeoPackage, GeoJSON or SVG, and chooses the
// names of layers in DXF. This file has the rows of the layers, too, ogr_drawing.h the coordinates and
// shapes of GDAL.

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/io/styles/qgis_style.h"
#include "core/measures/outlines/day_isochrones.h"
#include "core/measures/shadow_outlines.h"
#include "core/receivers/place.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// A moment as drawings name it.
struct DrawnTime {
    std::string name;   ///< "2026-03-21_0900": in names of layers and files
    std::string day;    ///< "2026-03-21": moments of a day share a fan
    std::string clock;  ///< "2026-03-21 09:00 America/New_York": as shown
    SunStep sun;
};

struct DrawnMoment {
    DrawnTime time;
    ShadowOutlines outlines;
};

struct DrawnFanStep {
    DrawnTime time;
    std::vector<Footprint> outlines;
};

/// A day's fan (core/measures/shadow_outlines.h).
struct DrawnFan {
    std::string name;  ///< "2026-03-21"
    std::vector<DrawnFanStep> steps;
    std::vector<Footprint> all;
};

/// Lines of equal minutes in shadow on a day.
struct DrawnIsochrones {
    std::string day;   ///< "2026-12-21"
    double cellM = 1;  ///< the lines are exact to a cell
    std::vector<Isochrone> lines;
};

/// The line that runs around the places of a rule at a distance (Japan: 5 and 10 m from the parcel).
struct DrawnDistance {
    double metres = 0;
    std::vector<Footprint> outlines;
};

enum class BuildingState {
    unchanged,
    proposed,  ///< of the scenario alone
    removed,   ///< of the baseline alone
};
std::string_view nameOf(BuildingState state);  ///< "unchanged", "proposed", "removed"

/// One part of a building.
struct DrawnPart {
    std::string id, name;  ///< of the building
    BuildingState state = BuildingState::unchanged;
    Footprint outline;
    double bottomM = 0, topM = 0;  ///< above the ground under the building
};

/// What a file of shadows holds. All polygons and lines are in local metres of the frame.
struct ShadowDrawing {
    Frame frame;
    Box2 area;  ///< shadows are cut at its edges
    std::vector<DrawnMoment> moments;
    std::vector<DrawnPart> buildings;
    std::vector<Place> places;
    std::vector<DrawnFan> fans;
    std::vector<DrawnIsochrones> isochrones;
    std::vector<DrawnDistance> distances;
    std::vector<std::string> notes;  ///< lines of text: scenarios, method, sources
};

/// The parts of a city's buildings that meet the area.
void addBuildings(const City& city, BuildingState state, const Box2& area, std::vector<DrawnPart>& to);

/// The places that meet the area.
std::vector<Place> choosePlacesIn(const std::vector<Place>& places, const Box2& area);

/// Which times to draw: of each day those named, or all of them while the sun is up.
struct DrawnTimeChoice {
    std::vector<std::string> days;   ///< "2026-03-21"
    std::vector<std::string> times;  ///< wall clock: "09:00"
    int everyMin = 0;                ///< from midnight on; 0: only the times
    std::string zone;                ///< "Europe/Monaco"
};

/// The times with the sun up, in order. A time that was asked for by name and has no sun gives a warning.
/// Error: no time, a date, a time or a zone that cannot be read, or no time with the sun up.
Result<std::vector<DrawnTime>> listDrawnTimes(const DrawnTimeChoice& choice, const City& city,
                                              Warnings& warnings);

/// Every day of a year, for DrawnTimeChoice::days.
std::vector<std::string> listDaysOf(int year);

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
