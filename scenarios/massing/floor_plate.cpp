#include "scenarios/massing/floor_plate.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "core/city/city.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/describe/field_values.h"
#include "scenarios/edits/placed_building.h"
#include "scenarios/massing/massing_fields.h"
#include "scenarios/massing/straight_skeleton.h"

namespace noonmark {

namespace {

constexpr std::size_t longestUse = 60;

Result<void> checkUse(const FloorUse& use, bool last) {
    if (use.use.empty() || use.use.size() > longestUse)
        return failure("A use of storeys has no name, or a very long one", "uses",
                       fmt::format("Give 1 to {} letters, such as offices", longestUse));
    if (auto sound = checkRanges(floorUseFields().of(use)); !sound) return sound;
    if (use.storeys > 0 || last) return {};
    return failure(fmt::format("{} takes all storeys above, and other uses follow", use.use), "uses",
                   "Give its number of storeys, or make it the last use");
}

}  // namespace

Result<void> checkUses(const std::vector<FloorUse>& uses) {
    for (const FloorUse& use : uses)
        if (const auto sound = checkUse(use, &use == &uses.back()); !sound) return sound;
    return {};
}

std::vector<UseArea> sumByUse(const std::vector<FloorUse>& uses, std::span<const double> storeyM2) {
    if (uses.empty()) return {};
    std::vector<UseArea> areas;
    const auto take = [&](const std::string& use, std::size_t storeys) {
        const auto some = storeyM2.first(std::min(storeys, storeyM2.size()));
        areas.push_back({use, int(some.size()), std::accumulate(some.begin(), some.end(), 0.0)});
        storeyM2 = storeyM2.subspan(some.size());
    };
    for (const FloorUse& use : uses)
        take(use.use, use.storeys == 0 ? storeyM2.size() : std::size_t(use.storeys));
    if (!storeyM2.empty()) take({}, storeyM2.size());
    return areas;
}

namespace {

constexpr double checkedEveryDeg = 5;
constexpr double sameHeightM = 1e-6;

double shareOfHeight(const Tier& tier, double heightM) {
    return std::clamp((heightM - tier.bottomM) / (tier.topM - tier.bottomM), 0.0, 1.0);
}

double scaleAt(const Tier& tier, double heightM) {
    return 1 - tier.walls.taper * shareOfHeight(tier, heightM);
}

glm::vec2 placePoint(glm::vec2 point, glm::dvec2 about, double scale, double clockwiseDeg) {
    const double angle = clockwiseDeg * std::numbers::pi / 180;
    const double cos = std::cos(angle), sin = std::sin(angle);
    const glm::dvec2 from = (glm::dvec2(point) - about) * scale;
    return glm::vec2(about + glm::dvec2(from.x * cos + from.y * sin, from.y * cos - from.x * sin));
}

// Stacks a prism's walls between levels. The first half of the prism's points are those of the bottom, the
// second half those of the top, in the same order; each level has the points of one half.
class WallStack {
public:
    WallStack(const TriangleMesh& prism, std::size_t levels)
        : prism_(prism),
          points_(std::uint32_t(prism.vertices.size() / 2)),
          last_(std::uint32_t(levels - 1) * points_) {}

    // Walls that only taper are plane.
    void addPlane(TriangleMesh& mesh) const {
        addCaps(mesh);
        for (const glm::uvec3 t : prism_.triangles)
            if (countLow(t) == 1 || countLow(t) == 2)
                for (std::uint32_t level = 0; level < last_; level += points_)
                    mesh.triangles.push_back(t + level);
    }

    // Each wall between two levels gets a point in its middle, on the ideal surface: with a diagonal instead,
    // all walls would lie outside of it, or all inside.
    void addTwisted(TriangleMesh& mesh) const {
        addCaps(mesh);
        for (const glm::uvec3 t : prism_.triangles)
            if (countLow(t) == 2)
                for (std::uint32_t level = 0; level < last_; level += points_)
                    addQuad(mesh, startOf(t) + level, endOf(t) + level);
    }

private:
    [[nodiscard]] int countLow(glm::uvec3 t) const {
        return int(t.x < points_) + int(t.y < points_) + int(t.z < points_);
    }
    // The edge at the bottom of a wall, in the order of the triangle that has it.
    [[nodiscard]] std::uint32_t startOf(glm::uvec3 t) const {
        return t.z >= points_ ? t.x : t.x >= points_ ? t.y : t.z;
    }
    [[nodiscard]] std::uint32_t endOf(glm::uvec3 t) const {
        return t.z >= points_ ? t.y : t.x >= points_ ? t.z : t.x;
    }

    void addCaps(TriangleMesh& mesh) const {
        for (const glm::uvec3 t : prism_.triangles) {
            if (countLow(t) == 3) mesh.triangles.push_back(t);
            if (countLow(t) == 0) mesh.triangles.push_back(t + (last_ - points_));
        }
    }

    void addQuad(TriangleMesh& mesh, std::uint32_t from, std::uint32_t to) const {
        const std::array<std::uint32_t, 4> corners{from, to, to + points_, from + points_};
        glm::vec3 sum(0);
        for (const std::uint32_t corner : corners) sum += mesh.vertices[corner];
        const auto middle = std::uint32_t(mesh.vertices.size());
        mesh.vertices.push_back(sum / 4.0F);
        for (std::size_t i = 0; i < 4; ++i)
            mesh.triangles.emplace_back(corners[i], corners[(i + 1) % 4], middle);
    }

    const TriangleMesh& prism_;
    std::uint32_t points_;
    std::uint32_t last_;  // first point of the top
};

}  // namespace

Plate plateAt(const Tier& tier, double heightM) {
    return placePlate(tier.plate, scaleAt(tier, heightM), tier.walls.twistDeg * shareOfHeight(tier, heightM));
}

double plateAreaAt(const Tier& tier, double heightM) {
    const double scale = scaleAt(tier, heightM);
    return tier.areaM2 * scale * scale;
}

Plate topPlateOf(const Tier& tier) { return plateAt(tier, tier.topM); }

std::vector<double> levelsOf(const Tier& tier, double storeyHeightM) {
    std::vector<double> levels{tier.bottomM};
    const auto climbTo = [&](double heightM) {
        const double fromM = levels.back();
        const double turnDeg = std::abs(tier.walls.twistDeg) * (heightM - fromM) / (tier.topM - tier.bottomM);
        const int steps = std::max(1, int(std::ceil(turnDeg / maxTurnBetweenLevelsDeg - 1e-9)));
        for (int i = 1; i <= steps; ++i) levels.push_back(fromM + (heightM - fromM) * i / steps);
    };
    if (tier.walls.twistDeg != 0)
        for (int floor = 1; floor * storeyHeightM < tier.topM - sameHeightM; ++floor)
            if (floor * storeyHeightM > tier.bottomM + sameHeightM) climbTo(floor * storeyHeightM);
    climbTo(tier.topM);
    return levels;
}

TriangleMesh makeLeaningMesh(const Tier& tier, const Footprint& piece, double storeyHeightM) {
    const TriangleMesh prism = meshOf(Part{.footprint = piece, .bottomM = 0, .topM = 1});
    const std::vector<double> levels = levelsOf(tier, storeyHeightM);
    const glm::dvec2 about = findMiddle(tier.plate);
    TriangleMesh mesh;
    for (const double level : levels)
        for (std::size_t i = 0; i < prism.vertices.size() / 2; ++i) {
            const glm::vec2 at = placePoint(glm::vec2(prism.vertices[i]), about, scaleAt(tier, level),
                                            tier.walls.twistDeg * shareOfHeight(tier, level));
            mesh.vertices.emplace_back(at, float(level));
        }
    const WallStack walls(prism, levels.size());
    tier.walls.twistDeg == 0 ? walls.addPlane(mesh) : walls.addTwisted(mesh);
    return mesh;
}

bool staysOn(const Tier& tier, const Footprint& lot) {
    const int steps = int(std::ceil(std::abs(tier.walls.twistDeg) / checkedEveryDeg));
    for (int i = 1; i <= steps; ++i) {
        const double heightM = tier.bottomM + (tier.topM - tier.bottomM) * i / steps;
        if (!liesOn(plateAt(tier, heightM), {lot})) return false;
    }
    return true;
}

namespace {

constexpr int halvings = 40;

Building asBuilding(const Plate& plate) {
    Building building;
    for (const Footprint& piece : plate) building.parts.push_back({.footprint = piece, .topM = 1});
    return building;
}

Plate movePlate(const Plate& plate, Placement placement) {
    const Building building = asBuilding(plate);
    placement.about = findMiddle(building);
    Plate result;
    for (Part& part : placeBuilding(building, placement).parts) result.push_back(std::move(part.footprint));
    return result;
}

// The argument at which the monotonic `areaAt` crosses `areaM2`, by bisection.
template <class AreaAt>
double argumentOf(double areaM2, double low, double high, bool rising, AreaAt&& areaAt) {
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        ((areaAt(middle) < areaM2) == rising ? low : high) = middle;
    }
    return (low + high) / 2;
}

Result<double> wantedArea(const Footprint& lot, const PlateSize& size) {
    const double lotM2 = area(lot);
    if (size.shareOfLot && !(*size.shareOfLot > 0 && *size.shareOfLot <= 1))
        return failure(fmt::format("A floor plate cannot cover {:g} % of the lot", *size.shareOfLot * 100),
                       "floor plate", "Give a share over 0 and up to 100 %");
    const double wanted = size.areaM2.value_or(size.shareOfLot.value_or(1) * lotM2);
    if (wanted > 0 && wanted <= lotM2 * (1 + 1e-9)) return std::min(wanted, lotM2);
    return failure(fmt::format("A floor plate of {:.0f} m2 does not fit the lot", wanted), "floor plate",
                   fmt::format("Give an area over 0 and up to the lot's {:.0f} m2", lotM2));
}

}  // namespace

Result<Plate> makePlate(const Footprint& lot, const PlateSize& size) {
    const auto wanted = wantedArea(lot, size);
    if (!wanted) return tl::make_unexpected(wanted.error());
    if (*wanted >= area(lot) * (1 - 1e-9)) return Plate{lot};
    const auto skeleton = StraightSkeleton::of(lot);
    if (!skeleton) return tl::make_unexpected(skeleton.error());
    const double inset = argumentOf(*wanted, 0, skeleton->deepestM(), false,
                                    [&](double distance) { return area(skeleton->inset(distance)); });
    Plate plate = skeleton->inset(inset);
    if (std::abs(area(plate) - *wanted) <= 0.001 * *wanted) return plate;
    return failure(fmt::format("The lot cannot be inset to a plate of {:.1f} m2", *wanted), "floor plate",
                   "Choose a larger plate");
}

glm::dvec2 findMiddle(const Plate& plate) { return findMiddle(asBuilding(plate)); }

Plate placePlate(const Plate& plate, double scale, double clockwiseDeg) {
    if (scale == 1 && clockwiseDeg == 0) return plate;
    return movePlate(plate, {.scale = scale, .clockwiseDeg = clockwiseDeg});
}

Plate turnPlate(const Plate& plate, double clockwiseDeg) { return placePlate(plate, 1, clockwiseDeg); }

Result<Plate> insetPlate(const Plate& plate, double insetM) {
    Plate left;
    double deepest = 0;
    for (const Footprint& piece : plate) {
        const auto skeleton = StraightSkeleton::of(piece);
        if (!skeleton) return tl::make_unexpected(skeleton.error());
        deepest = std::max(deepest, skeleton->deepestM());
        for (Footprint& inner : skeleton->inset(insetM)) left.push_back(std::move(inner));
    }
    if (!left.empty()) return left;
    return failure(fmt::format("A setback of {:g} m leaves nothing of the floor plate", insetM), "setback",
                   fmt::format("Give less than {:.1f} m", deepest));
}

bool liesOn(const Plate& plate, const Plate& ground) {
    double outside = 0;
    for (const Footprint& piece : plate) outside += computeAreaOutside(piece, ground);
    return outside <= 0.0002 * area(plate) + 0.05;
}

Plate resizePlate(const Plate& plate, const Footprint& lot, double areaM2) {
    const auto at = [&](double scale) {
        const Plate scaled = movePlate(plate, {.scale = scale});
        return scale > 1 ? cutSharedPieces(scaled, {lot}) : scaled;
    };
    const double even = std::sqrt(areaM2 / area(plate));
    if (even <= 1) return at(even);
    // Factor at which the scaled plate covers even the farthest corner of the lot.
    const Box2 lotBox = bounds(lot), box = bounds(plate.front());
    const double reach = 4 * double(glm::length(lotBox.high - lotBox.low) / glm::length(box.high - box.low));
    return at(argumentOf(areaM2, 1, std::max(even, reach) * 10, true,
                         [&](double scale) { return area(at(scale)); }));
}

}  // namespace noonmark
