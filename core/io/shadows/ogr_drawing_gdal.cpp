#include <fmt/format.h>
#include <ogr_geometry.h>
#include <ogr_spatialref.h>

#include <cmath>

#include "core/base/gdal_calls.h"
#include "core/geo/longitude.h"
#include "core/io/shadows/ogr_drawing.h"

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

}  // namespace noonmark
