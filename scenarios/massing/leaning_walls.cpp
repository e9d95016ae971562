#include "scenarios/massing/leaning_walls.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/city/city.h"

namespace noonmark {

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

}  // namespace noonmark
