#include "core/io/shadows/ogr_drawing.h"

#include <cpl_error.h>
#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_geometry.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/gdal_calls.h"
#include "core/geo/lon_lat.h"
#include "core/io/footprints/ogr_polygons.h"
#include "core/io/shadows/shadow_drawing.h"
#include "core/io/shadows/write_shadows.h"
#include "core/io/styles/qgis_style.h"

namespace noonmark {

namespace {

OGRSpatialReference wgs84() {
    OGRSpatialReference system;
    system.importFromEPSG(4326);
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

bool hasUtmZone(LonLat origin) { return origin.latDeg >= -80 && origin.latDeg <= 84; }

int utmCode(LonLat origin) {
    const int zone = int(std::floor((wrapLongitude(origin.lonDeg) + 180) / 6)) % 60 + 1;
    return (origin.latDeg < 0 ? 32700 : 32600) + zone;
}

OGRSpatialReference systemOf(LonLat origin, DrawingPlane plane) {
    OGRSpatialReference system;
    if (plane == DrawingPlane::utm) {
        system.importFromEPSG(utmCode(origin));
    } else {
        system.SetProjCS("Noonmark: transverse Mercator at the project's origin");
        system.SetWellKnownGeogCS("WGS84");
        system.SetTM(origin.latDeg, origin.lonDeg, 1, 0, 0);
        system.SetLinearUnits(SRS_UL_METER, 1);
    }
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

Result<void> checkPlane(const Frame& frame, DrawingPlane plane) {
    if (plane == DrawingPlane::local || hasUtmZone(frame.origin())) return {};
    return failure(fmt::format("There is no UTM zone at latitude {:.2f}", frame.origin().latDeg), "plane",
                   "Choose the local plane");
}

}  // namespace

struct OgrDrawing::Parts {
    struct Destroy {
        void operator()(OGRCoordinateTransformation* it) const { OGRCoordinateTransformation::DestroyCT(it); }
    };
    Frame frame;
    OGRSpatialReference system;
    std::unique_ptr<OGRCoordinateTransformation, Destroy> transformation;  ///< null: none
};

OgrDrawing::OgrDrawing(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
OgrDrawing::OgrDrawing(OgrDrawing&&) noexcept = default;
OgrDrawing& OgrDrawing::operator=(OgrDrawing&&) noexcept = default;
OgrDrawing::~OgrDrawing() = default;

Result<OgrDrawing> OgrDrawing::inPlane(const Frame& frame, DrawingPlane plane) {
    const GdalCalls calls;
    if (auto checked = checkPlane(frame, plane); !checked) return tl::make_unexpected(checked.error());
    auto parts = std::make_unique<Parts>();
    parts->frame = frame;
    parts->system = systemOf(frame.origin(), plane);
    OGRSpatialReference from = wgs84();
    parts->transformation.reset(OGRCreateCoordinateTransformation(&from, &parts->system));
    if (!parts->transformation || calls.failed())
        return internalError("The plane of the drawing could not be set up: " + calls.why(), "plane");
    return OgrDrawing(std::move(parts));
}

Result<OgrDrawing> OgrDrawing::inLonLat(const Frame& frame) {
    const GdalCalls calls;
    auto parts = std::make_unique<Parts>();
    parts->frame = frame;
    parts->system = wgs84();
    return OgrDrawing(std::move(parts));
}

const OGRSpatialReference& OgrDrawing::system() const { return parts_->system; }

glm::dvec2 OgrDrawing::place(glm::dvec2 local) const {
    const LonLat place = parts_->frame.lonLatFromLocal(local);
    glm::dvec2 at(wrapLongitudeNear(place.lonDeg, parts_->frame.origin().lonDeg), place.latDeg);
    if (parts_->transformation) parts_->transformation->Transform(1, &at.x, &at.y);
    return at;
}

std::unique_ptr<OGRGeometry> OgrDrawing::polygon(const Footprint& footprint) const {
    auto polygon = std::make_unique<OGRPolygon>();
    const auto add = [&](const Ring& ring) {
        OGRLinearRing closed;
        for (const glm::vec2 point : ring) {
            const glm::dvec2 at = place(glm::dvec2(point));
            closed.addPoint(at.x, at.y);
        }
        closed.closeRings();
        polygon->addRing(&closed);
    };
    add(footprint.outer);
    for (const Ring& hole : footprint.holes) add(hole);
    polygon->flattenTo2D();
    return polygon;
}

std::unique_ptr<OGRGeometry> OgrDrawing::multiPolygon(const std::vector<Footprint>& footprints) const {
    auto all = std::make_unique<OGRMultiPolygon>();
    for (const Footprint& footprint : footprints) all->addGeometryDirectly(polygon(footprint).release());
    return all;
}

std::unique_ptr<OGRGeometry> OgrDrawing::line(const std::vector<glm::vec2>& points) const {
    auto line = std::make_unique<OGRLineString>();
    for (const glm::vec2 point : points) {
        const glm::dvec2 at = place(glm::dvec2(point));
        line->addPoint(at.x, at.y);
    }
    line->flattenTo2D();
    return line;
}

Result<std::string> describePlane(const Frame& frame, DrawingPlane plane) {
    if (auto checked = checkPlane(frame, plane); !checked) return tl::make_unexpected(checked.error());
    const LonLat origin = frame.origin();
    if (plane == DrawingPlane::utm)
        return fmt::format("EPSG:{}, WGS 84 / UTM zone {}{}, metres", utmCode(origin), utmCode(origin) % 100,
                           origin.latDeg < 0 ? 'S' : 'N');
    return fmt::format(
        "Transverse Mercator on WGS84, metres: origin (0, 0) and scale 1 at latitude {:.8f}, longitude "
        "{:.8f}; "
        "+proj=tmerc +lat_0={:.10g} +lon_0={:.10g} +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m",
        origin.latDeg, origin.lonDeg, origin.latDeg, origin.lonDeg);
}

namespace {

OGRFieldType typeOf(const DrawingValue& value) {
    if (std::holds_alternative<double>(value)) return OFTReal;
    return std::holds_alternative<Instant>(value) ? OFTDateTime : OFTString;
}

void setInstant(OGRFeature& feature, int field, Instant at) {
    using namespace std::chrono;
    constexpr int utc = 100;  // GDAL's number of the time zone
    const auto day = floor<days>(at);
    const year_month_day date(day);
    const hh_mm_ss time(at - day);
    feature.SetField(field, int(date.year()), int(unsigned(date.month())), int(unsigned(date.day())),
                     int(time.hours().count()), int(time.minutes().count()),
                     float(duration<double>(at - day - time.hours() - time.minutes()).count()), utc);
}

void setValue(OGRFeature& feature, int field, const DrawingValue& value) {
    if (const auto* text = std::get_if<std::string>(&value))
        feature.SetField(field, text->c_str());
    else if (const auto* number = std::get_if<double>(&value))
        feature.SetField(field, *number);
    else
        setInstant(feature, field, std::get<Instant>(value));
}

// Where a corner lies on another edge, the change of coordinates may move it across that edge by a nanometre.
std::unique_ptr<OGRGeometry> validPolygons(std::unique_ptr<OGRGeometry> polygons) {
    CPLErrorHandlerPusher quiet(CPLQuietErrorHandler);  // IsValid reports each defect
    if (polygons->IsValid()) return polygons;
    std::unique_ptr<OGRGeometry> valid(polygons->MakeValid());
    if (!valid) return polygons;
    auto all = std::make_unique<OGRMultiPolygon>();
    for (const CrsPolygon& rings : readPolygons(*valid)) {
        OGRPolygon polygon;
        for (const auto& ring : rings) {
            OGRLinearRing line;
            for (const glm::dvec2 point : ring) line.addPoint(point.x, point.y);
            line.closeRings();
            polygon.addRing(&line);
        }
        polygon.flattenTo2D();
        all->addGeometry(&polygon);
    }
    return all;
}

bool writeRow(OGRLayer& layer, const DrawingTable& table, const DrawingRow& row, const OgrDrawing& shapes) {
    OGRFeature feature(layer.GetLayerDefn());
    for (std::size_t i = 0; i < row.values.size(); ++i) setValue(feature, int(i), row.values[i]);
    if (!table.isOfLines) {
        feature.SetGeometryDirectly(validPolygons(shapes.multiPolygon(row.polygons)).release());
        return layer.CreateFeature(&feature) == OGRERR_NONE;
    }
    return std::ranges::all_of(row.lines, [&](const auto& points) {
        feature.SetFID(OGRNullFID);
        feature.SetGeometryDirectly(shapes.line(points).release());
        return layer.CreateFeature(&feature) == OGRERR_NONE;
    });
}

bool writeTable(GDALDataset& dataset, const DrawingTable& table, const OgrDrawing& shapes,
                CPLStringList options) {
    OGRSpatialReference system(shapes.system());
    OGRLayer* layer = dataset.CreateLayer(table.name.c_str(), &system,
                                          table.isOfLines ? wkbLineString : wkbMultiPolygon, options.List());
    if (layer == nullptr) return false;
    for (const DrawingColumn& column : table.columns) {
        OGRFieldDefn field(column.name.c_str(), typeOf(column.kind));
        if (layer->CreateField(&field) != OGRERR_NONE) return false;
    }
    return std::ranges::all_of(table.rows,
                               [&](const DrawingRow& row) { return writeRow(*layer, table, row, shapes); });
}

GDALDatasetUniquePtr create(const char* name, const std::filesystem::path& file) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(name);
    return GDALDatasetUniquePtr(
        driver == nullptr ? nullptr : driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
}

Result<void> notWritten(const char* what, const std::filesystem::path& file, const GdalCalls& calls) {
    return failure(std::string(what) + " could not be written: " + calls.why(), file.string(),
                   "Check that the folder exists, is writable and has space");
}

}  // namespace

Result<void> writeShadowsGeoPackage(const std::filesystem::path& file, const ShadowDrawing& drawing,
                                    DrawingPlane plane) {
    const auto shapes = OgrDrawing::inPlane(drawing.frame, plane);
    if (!shapes) return tl::make_unexpected(shapes.error());
    const GdalCalls calls;
    GDALDatasetUniquePtr dataset = create("GPKG", file);
    bool written = dataset && dataset->StartTransaction() == OGRERR_NONE;
    for (const DrawingTable& table : makeDrawingTables(drawing)) {
        written = written && writeTable(*dataset, table, *shapes, {});
        if (written) writeLayerStyle(*dataset, *dataset->GetLayerByName(table.name.c_str()), table.style);
    }
    written = written && dataset->CommitTransaction() == OGRERR_NONE;
    dataset.reset();
    return written && !calls.failed() ? Result<void>() : notWritten("The GeoPackage", file, calls);
}

Result<void> writeShadowsGeoJson(const std::filesystem::path& file, const ShadowDrawing& drawing,
                                 const std::string& layer) {
    const auto tables = makeDrawingTables(drawing);
    const auto table = std::ranges::find(tables, layer, &DrawingTable::name);
    if (table == tables.end()) return failure("The drawing has no such layer", layer, "Choose another layer");
    const auto shapes = OgrDrawing::inLonLat(drawing.frame);
    if (!shapes) return tl::make_unexpected(shapes.error());
    const GdalCalls calls;
    CPLStringList options;
    options.SetNameValue("RFC7946", "YES");
    options.SetNameValue("COORDINATE_PRECISION", "9");  // 0.1 mm
    GDALDatasetUniquePtr dataset = create("GeoJSON", file);
    const bool written = dataset && writeTable(*dataset, *table, *shapes, options);
    dataset.reset();
    return written && !calls.failed() ? Result<void>() : notWritten("The GeoJSON file", file, calls);
}

}  // namespace noonmark
