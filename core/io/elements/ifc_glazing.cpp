#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>

#include "core/geo/lon_lat.h"
#include "core/io/elements/read_glazing.h"
#include "core/io/meshes/ifc_site.h"
#include "core/io/meshes/mesh_placement.h"
#include "core/io/meshes/mesh_reader_process.h"
#include "core/io/settings/read_settings.h"
#include "core/receivers/point_receivers.h"
#include "core/receivers/points/glazing_pane.h"

namespace noonmark {

namespace {

using Points3d = std::vector<glm::dvec3>;

constexpr double nowhereM = std::numeric_limits<double>::infinity();
constexpr double deepestRevealM = 0.8;

/// Triangles in local metres, z as in the model.
struct IfcBody {
    std::string name;
    std::vector<std::array<glm::dvec3, 3>> triangles;
    double lowM = nowhereM, highM = -nowhereM;
    glm::dvec2 middle{0};

    void add(const Points3d& points, const MeshPiece& piece) {
        auto corner = piece.corners.begin();
        for (const std::uint32_t count : piece.cornerCounts) {
            addFan(points, corner, count);
            corner += count;
        }
    }

    void finish() {
        glm::dvec2 low(nowhereM), high(-nowhereM);
        for (const auto& triangle : triangles)
            for (const glm::dvec3& point : triangle) {
                low = glm::min(low, glm::dvec2(point));
                high = glm::max(high, glm::dvec2(point));
                lowM = std::min(lowM, point.z);
                highM = std::max(highM, point.z);
            }
        middle = (low + high) / 2.0;
    }

private:
    // What cannot be placed, and corners that the file lacks, is left out.
    void addFan(const Points3d& points, std::vector<std::uint32_t>::const_iterator corner,
                std::uint32_t count) {
        const auto good = [&](std::uint32_t i) {
            return i < points.size() && std::isfinite(points[i].x + points[i].y + points[i].z);
        };
        for (std::uint32_t i = 1; i + 1 < count; ++i)
            if (good(corner[0]) && good(corner[i]) && good(corner[i + 1]))
                triangles.push_back({points[corner[0]], points[corner[i]], points[corner[i + 1]]});
    }
};

IfcBody bodyOf(const MeshObject& object, const MeshPlacement& placement) {
    IfcBody body{object.name, {}};
    for (const MeshPiece& piece : object.pieces) body.add(placement.local(piece), piece);
    body.finish();
    return body;
}

// Distance to the first triangle along a ray, metres.
double firstHitM(const IfcBody& body, glm::dvec3 from, glm::dvec3 direction) {
    double nearest = nowhereM;
    for (const auto& [a, b, c] : body.triangles) {
        const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(direction, ac);
        const double turn = glm::dot(ab, p);
        if (std::abs(turn) < 1e-12) continue;
        const glm::dvec3 offset = from - a, q = glm::cross(offset, ab);
        const double u = glm::dot(offset, p) / turn, v = glm::dot(direction, q) / turn;
        const double along = glm::dot(ac, q) / turn;
        if (u >= 0 && v >= 0 && u + v <= 1 && along > 1e-6) nearest = std::min(nearest, along);
    }
    return nearest;
}

/// The rectangle around the body of a window, across its thinnest direction.
struct IfcPane {
    glm::dvec3 middle{0}, normal{0};
    double halfWidthM = 0, halfHeightM = 0, halfDepthM = 0;

    [[nodiscard]] PaneAxes axes() const { return findPaneAxes(normal); }
    [[nodiscard]] Points3d corners() const {
        const auto [along, up] = axes();
        const glm::dvec3 across = halfWidthM * along, upward = halfHeightM * up;
        return {middle - across - upward, middle + across - upward, middle + across + upward,
                middle - across + upward};
    }
};

std::pair<double, double> rangeAlong(const IfcBody& body, glm::dvec3 direction) {
    std::pair range{nowhereM, -nowhereM};
    for (const auto& triangle : body.triangles)
        for (const glm::dvec3& point : triangle) {
            range.first = std::min(range.first, glm::dot(point, direction));
            range.second = std::max(range.second, glm::dot(point, direction));
        }
    return range;
}

std::optional<glm::dvec3> thinnestDirection(const IfcBody& body) {
    constexpr std::size_t mostTried = 200;
    std::optional<glm::dvec3> thinnest;
    double minM = nowhereM;
    const std::size_t step = body.triangles.size() / mostTried + 1;
    for (std::size_t i = 0; i < body.triangles.size(); i += step) {
        const auto& [a, b, c] = body.triangles[i];
        const glm::dvec3 area = glm::cross(b - a, c - a);
        if (glm::length(area) < 1e-9) continue;
        const glm::dvec3 normal = glm::normalize(area);
        const auto [low, high] = rangeAlong(body, normal);
        if (high - low < minM - 1e-6) minM = high - low, thinnest = normal;
    }
    return thinnest;
}

std::optional<IfcPane> paneAround(const IfcBody& body) {
    const auto normal = thinnestDirection(body);
    if (!normal) return std::nullopt;
    IfcPane pane{.normal = *normal};
    const auto [along, up] = pane.axes();
    const auto widths = rangeAlong(body, along), heights = rangeAlong(body, up),
               depths = rangeAlong(body, *normal);
    const auto middle = [](const auto& range) { return (range.first + range.second) / 2; };
    const auto half = [](const auto& range) { return (range.second - range.first) / 2; };
    pane.middle = middle(widths) * along + middle(heights) * up + middle(depths) * *normal;
    pane.halfWidthM = half(widths), pane.halfHeightM = half(heights), pane.halfDepthM = half(depths);
    return pane;
}

// How many of some directions into the half space in front meet nothing.
int countOpen(const IfcBody& building, const IfcPane& pane, glm::dvec3 normal) {
    const auto [along, up] = findPaneAxes(normal);
    const glm::dvec3 from = pane.middle + (pane.halfDepthM + 0.01) * normal;
    int open = 0;
    for (const double side : {-0.6, 0.0, 0.6})
        for (const double rise : {0.1, 0.4, 1.0})
            if (std::isinf(firstHitM(building, from, glm::normalize(normal + side * along + rise * up))))
                ++open;
    return open;
}

// Beside the opening and below it the outer face of the wall is met from within.
double distanceToFaceM(const IfcBody& building, const IfcPane& pane) {
    constexpr double besideM = 0.1;
    const auto [along, up] = pane.axes();
    double distanceM = pane.halfDepthM;
    for (const glm::dvec3 beside : {(pane.halfWidthM + besideM) * along, -(pane.halfWidthM + besideM) * along,
                                    -(pane.halfHeightM + besideM) * up}) {
        const double hitM = firstHitM(building, pane.middle + beside, pane.normal);
        if (hitM <= deepestRevealM) distanceM = std::max(distanceM, hitM);
    }
    return distanceM;
}

// Whether it opens to one side of the building; turns the pane to it and moves it to the wall's outer face.
bool turnOutward(const IfcBody& building, IfcPane& pane) {
    constexpr int fewestOpen = 2;
    const int front = countOpen(building, pane, pane.normal), back = countOpen(building, pane, -pane.normal);
    if (std::max(front, back) < fewestOpen) return false;
    if (back > front) pane.normal = -pane.normal;
    pane.middle += distanceToFaceM(building, pane) * pane.normal;
    return true;
}

// The direction of `normal` on the map, from true north, clockwise.
double azimuthOf(const Frame& frame, glm::dvec3 place, glm::dvec3 normal) {
    const glm::dmat2 turn = frame.localFromEastNorth(frame.lonLatFromLocal(glm::dvec2(place)));
    const glm::dvec2 eastNorth = glm::inverse(turn) * glm::dvec2(normal);
    return std::atan2(eastNorth.x, eastNorth.y) * 180 / std::numbers::pi;
}

// The building of the city at the place of the model's that is as tall.
std::optional<double> baseInCity(const City& city, const IfcBody& model) {
    constexpr double sameM = 0.05;
    for (const auto& building : city.buildings) {
        if (building->parts.empty()) continue;
        const Box2 box = bounds(*building);
        const bool isThere = model.middle.x >= double(box.low.x) && model.middle.x <= double(box.high.x) &&
                             model.middle.y >= double(box.low.y) && model.middle.y <= double(box.high.y);
        const float lowM = std::ranges::min_element(building->parts, {}, &Part::bottomM)->bottomM;
        if (isThere && std::abs(double(topM(*building) - lowM) - (model.highM - model.lowM)) < sameM)
            return double(lowM);
    }
    return std::nullopt;
}

class IfcGlazingReader {
public:
    IfcGlazingReader(const MeshScene& scene, const MeshPlacement& placement, const City& city,
                     std::string file)
        : scene_(scene), placement_(placement), city_(city), file_(std::move(file)) {}

    void read(GlazingRead& read, const std::stop_token& stop) {
        for (const MeshObject& object : scene_)
            if (object.kind == MeshObject::Kind::building) addBuilding(object, read);
        std::vector<const MeshObject*> openings;
        for (const MeshObject& object : scene_)
            if (object.isOpening()) openings.push_back(&object);
        read.features = openings.size();
        std::vector<std::optional<GlazingShape>> made(openings.size());
        tbb::parallel_for(std::size_t{0}, openings.size(), [&](std::size_t i) {
            if (!stop.stop_requested()) made[i] = shapeOf(*openings[i]);
        });
        for (std::size_t i = 0; i < made.size(); ++i)
            if (made[i])
                read.windows.push_back(*std::move(made[i]));
            else
                read.warnings.push_back({WarningKind::leftOut,
                                         "windows and doors that open to no side, as "
                                         "those between rooms",
                                         fmt::format("{}: {}", file_, openings[i]->name)});
    }

private:
    struct Standing {
        IfcBody body;
        double raisedM = 0;
    };

    void addBuilding(const MeshObject& object, GlazingRead& read) {
        IfcBody body = bodyOf(object, placement_);
        const auto base = baseInCity(city_, body);
        if (!base)
            read.warnings.push_back({WarningKind::assumed,
                                     "the city has not this building of the IFC; its windows stand on the "
                                     "ground",
                                     fmt::format("{}: {}", file_, body.name)});
        const double baseM = base ? *base : double(groundAt(city_, body.middle));
        const double raisedM = baseM - body.lowM;
        buildings_.push_back({std::move(body), raisedM});
    }

    [[nodiscard]] std::optional<GlazingShape> shapeOf(const MeshObject& object) const {
        const auto building = std::ranges::find(buildings_, object.parent,
                                                [](const Standing& standing) { return standing.body.name; });
        auto pane = paneAround(bodyOf(object, placement_));
        if (building == buildings_.end() || !pane || !turnOutward(building->body, *pane)) return std::nullopt;
        GlazingShape shape{.id = object.name, .corners = pane->corners(), .floor = object.floor};
        for (glm::dvec3& corner : shape.corners) corner.z += building->raisedM;
        shape.azimuthDeg = azimuthOf(city_.frame, pane->middle, pane->normal);
        return shape;
    }

    const MeshScene& scene_;
    const MeshPlacement& placement_;
    const City& city_;
    std::string file_;
    std::vector<Standing> buildings_;
};

Error checkOpenings(const GlazingRead& read, const std::filesystem::path& file) {
    if (read.features > 0)
        return failure("None of its windows and doors opens to one side", file.string(),
                       "Export the walls with them")
            .value();
    return failure("The IFC has no windows and doors", file.string(),
                   "Export the building with its classes IfcWindow and IfcDoor")
        .value();
}

std::optional<ModelPlace> findModelPlace(const std::filesystem::path& file,
                                         const GlazingFileSettings& settings, const std::stop_token& stop) {
    if (settings.place) return settings.place;
    const auto stated = findPlace(readIfcSite(file, stop));
    return stated ? std::optional(ModelPlace{stated->origin, stated->northDeg}) : std::nullopt;
}

Result<ReadSettings> placeOfIfc(const std::filesystem::path& file, const GlazingFileSettings& settings,
                                const City& city, const std::stop_token& stop) {
    const auto place = findModelPlace(file, settings, stop);
    if (!place)
        return failure(
            "The IFC does not state where it stands", file.string(),
            fmt::format("Read it as part of the city with {}, import it into a scenario, or export "
                        "it with the latitude and longitude of its IfcSite",
                        readOption("mesh_anchor", "LON,LAT")));
    if (computeGreatCircleM(place->origin, city.frame.origin()) > settings.farAwayM)
        return failure("All windows are too far from the city", file.string(),
                       fmt::format("The IFC stands at {:.6f},{:.6f}; check that", place->origin.lonDeg,
                                   place->origin.latDeg));
    ReadSettings reading;
    reading.meshAnchor = place->origin;
    reading.meshNorthDeg = place->northDeg;
    reading.meshScale = place->scale;
    reading.frame = city.frame;
    return reading;
}

}  // namespace

Result<GlazingRead> readIfcGlazing(const std::filesystem::path& file, const GlazingFileSettings& settings,
                                   const City& city, const std::stop_token& stop) {
    const auto reading = placeOfIfc(file, settings, city, stop);
    if (!reading) return tl::make_unexpected(reading.error());
    const auto scene = readMeshScene(file, meshReaderLimits(std::filesystem::file_size(file)), stop);
    if (!scene) return tl::make_unexpected(scene.error());
    GlazingRead read;
    const std::string name = file.filename().string();
    const auto placement = MeshPlacement::of(*scene, {file.string(), name, "IFC", findStatedAxes(file)},
                                             *reading, read.warnings);
    if (!placement) return tl::make_unexpected(placement.error());
    IfcGlazingReader(*scene, *placement, city, name).read(read, stop);
    if (stop.stop_requested()) return cancelled();
    if (read.windows.size() > GlazingFileSettings::maxWindows)
        return limitReached(fmt::format("It holds more than {} windows", GlazingFileSettings::maxWindows),
                            name, "Divide the file");
    if (read.windows.empty()) return tl::make_unexpected(checkOpenings(read, file));
    return read;
}

}  // namespace noonmark
