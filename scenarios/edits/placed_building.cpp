#include "scenarios/edits/placed_building.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/city/building_heights.h"
#include "core/city/footprints/repair_footprint.h"

namespace noonmark {

namespace {

class Motion {
public:
    explicit Motion(const Placement& placement) : placement_(placement) {
        const double angle = placement.clockwiseDeg * std::numbers::pi / 180;
        cos_ = std::cos(angle);
        sin_ = std::sin(angle);
    }

    [[nodiscard]] glm::dvec2 operator()(glm::dvec2 point) const {
        const glm::dvec2 from = (point - placement_.about) * placement_.scale;
        const glm::dvec2 turned{from.x * cos_ + from.y * sin_, from.y * cos_ - from.x * sin_};
        return placement_.about + turned + placement_.byM;
    }

    [[nodiscard]] float z(float value) const { return float(double(value) * placement_.scale); }

private:
    Placement placement_;
    double cos_ = 1, sin_ = 0;
};

RawRing applyMotion(const Ring& ring, const Motion& motion) {
    RawRing points;
    for (const glm::vec2 point : ring) points.push_back(motion(glm::dvec2(point)));
    return points;
}

std::vector<Footprint> applyMotion(const Footprint& footprint, const Motion& motion) {
    std::vector<RawRing> rings{applyMotion(footprint.outer, motion)};
    for (const Ring& hole : footprint.holes) rings.push_back(applyMotion(hole, motion));
    return repairFootprint(rings).pieces;
}

std::shared_ptr<const TriangleMesh> applyMotion(const TriangleMesh& mesh, const Motion& motion) {
    auto result = std::make_shared<TriangleMesh>(mesh);
    for (glm::vec3& vertex : result->vertices) {
        const glm::dvec2 point = motion({vertex.x, vertex.y});
        vertex = {float(point.x), float(point.y), motion.z(vertex.z)};
    }
    return result;
}

// A mesh is one solid, so it stays with the first piece of its outline.
void addMoved(const Part& part, const Motion& motion, std::vector<Part>& parts) {
    for (Footprint& piece : applyMotion(part.footprint, motion)) {
        Part copy = part;
        copy.footprint = std::move(piece);
        copy.bottomM = motion.z(part.bottomM);
        copy.topM = motion.z(part.topM);
        if (part.mesh) copy.mesh = applyMotion(*part.mesh, motion);
        parts.push_back(std::move(copy));
        if (part.mesh) return;
    }
}

bool hasMesh(const Building& building) {
    return std::ranges::any_of(building.parts, [](const Part& part) { return part.mesh != nullptr; });
}

Building stretch(Building building, double groundM, double factor) {
    const auto z = [=](float value) { return float(groundM + (double(value) - groundM) * factor); };
    for (Part& part : building.parts) {
        part.bottomM = z(part.bottomM);
        part.topM = z(part.topM);
        part.heightSource = HeightSource::designed;
        if (!part.mesh) continue;
        auto mesh = std::make_shared<TriangleMesh>(*part.mesh);
        for (glm::vec3& vertex : mesh->vertices) vertex.z = z(vertex.z);
        part.mesh = std::move(mesh);
    }
    return building;
}

Building cutOrRaised(Building building, float oldTop, float newTop) {
    std::erase_if(building.parts, [=](const Part& part) { return part.bottomM >= newTop; });
    for (Part& part : building.parts) {
        const bool changes = part.topM == oldTop || part.topM > newTop;
        if (!changes) continue;
        part.topM = newTop;
        part.heightSource = HeightSource::designed;
    }
    return building;
}

}  // namespace

glm::dvec2 applyTo(glm::dvec2 point, const Placement& placement) { return Motion(placement)(point); }

Building placeBuilding(const Building& building, const Placement& placement) {
    if (placement == Placement{.about = placement.about}) return building;
    const Motion motion(placement);
    Building result = building;
    result.parts.clear();
    for (const Part& part : building.parts) addMoved(part, motion, result.parts);
    return result;
}

Building liftBuilding(Building building, double byM) {
    if (byM == 0) return building;
    for (Part& part : building.parts) {
        part.bottomM = float(part.bottomM + byM);
        part.topM = float(part.topM + byM);
        if (!part.mesh) continue;
        auto mesh = std::make_shared<TriangleMesh>(*part.mesh);
        for (glm::vec3& vertex : mesh->vertices) vertex.z = float(vertex.z + byM);
        part.mesh = std::move(mesh);
    }
    return building;
}

Result<Building> withHeight(const Building& building, double groundM, double heightM) {
    if (!(heightM >= 0.1 && heightM <= tallestBuildingM))
        return failure(fmt::format("A building cannot be {:g} m high", heightM), building.sourceId,
                       "Give a height of 0.1 to 2000 m, or demolish it");
    const float oldTop = topM(building);
    const float newTop = float(groundM + heightM);
    if (hasMesh(building)) return stretch(building, groundM, heightM / (double(oldTop) - groundM));
    Building changed = cutOrRaised(building, oldTop, newTop);
    if (!changed.parts.empty()) return changed;
    return failure(fmt::format("No part of the building begins below {:g} m", heightM), building.sourceId,
                   "Choose a greater height, or demolish it");
}

glm::dvec2 findMiddle(const Building& building) {
    glm::dvec2 sum{0, 0};
    double weight = 0;
    for (const Part& part : building.parts) {
        const glm::dvec2 first(part.footprint.outer.front());
        const Ring& ring = part.footprint.outer;
        for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
            const glm::dvec2 a = glm::dvec2(ring[i]) - first, b = glm::dvec2(ring[i + 1]) - first;
            const double area = (a.x * b.y - a.y * b.x) / 2;
            sum += (first + (a + b) / 3.0) * area;
            weight += area;
        }
    }
    if (weight > 0) return sum / weight;
    const Box2 box = bounds(building);
    return glm::dvec2(box.low + box.high) / 2.0;
}

}  // namespace noonmark
