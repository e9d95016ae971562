#include "core/study/elements/points_on_surfaces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace noonmark {

namespace {

constexpr double cellM = 4, minSameWay = 0.7, maxCells = 1e6;

using Rings = std::vector<std::vector<glm::dvec3>>;

int cellOf(double metres) { return int(std::floor(std::clamp(metres, -1e8, 1e8) / cellM)); }

// Newell's method: for polygons that are not quite flat, too.
glm::dvec3 findNormal(const std::vector<glm::dvec3>& ring) {
    glm::dvec3 normal(0);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        normal += glm::dvec3((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y));
    }
    const double length = glm::length(normal);
    return length > 0 ? normal / length : glm::dvec3(0);
}

glm::dvec3 middleOf(const std::vector<glm::dvec3>& ring) {
    glm::dvec3 sum(0);
    for (const glm::dvec3& corner : ring) sum += corner;
    return sum / double(ring.size());
}

// Even-odd, over all rings, in the plane of the polygon.
bool isInside(const Rings& rings, const PaneAxes& axes, glm::dvec3 place) {
    bool inside = false;
    const glm::dvec2 at(glm::dot(place, axes.along), glm::dot(place, axes.up));
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec3 &one = ring[i], &two = ring[(i + 1) % ring.size()];
            const glm::dvec2 a(glm::dot(one, axes.along), glm::dot(one, axes.up));
            const glm::dvec2 b(glm::dot(two, axes.along), glm::dot(two, axes.up));
            if ((a.y > at.y) == (b.y > at.y)) continue;
            if (at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
        }
    return inside;
}

}  // namespace

PointsOnSurfaces::PointsOnSurfaces(const ElementMap& map) : map_(map) {
    for (std::size_t i = 0; i < map_.elements.size(); ++i) {
        const glm::vec3& at = map_.elements[i].position;
        cells_[{cellOf(double(at.x)), cellOf(double(at.y))}].push_back(i);
    }
}

std::vector<std::size_t> PointsOnSurfaces::find(const Rings& rings) const {
    std::vector<std::size_t> found;
    if (rings.empty() || rings.front().size() < 3) return found;
    const glm::dvec3 normal = findNormal(rings.front()), middle = middleOf(rings.front());
    if (normal == glm::dvec3(0)) return found;
    const PaneAxes axes = findPaneAxes(normal);
    glm::dvec2 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
    for (const glm::dvec3& corner : rings.front()) {
        low = glm::min(low, glm::dvec2(corner) - maxDistanceM);
        high = glm::max(high, glm::dvec2(corner) + maxDistanceM);
    }
    if ((high.x - low.x) / cellM * ((high.y - low.y) / cellM) > maxCells) return found;
    for (int x = cellOf(low.x); x <= cellOf(high.x); ++x)
        for (int y = cellOf(low.y); y <= cellOf(high.y); ++y) {
            const auto cell = cells_.find({x, y});
            if (cell == cells_.end()) continue;
            for (const std::size_t i : cell->second) {
                const glm::dvec3 place(map_.elements[i].position);
                const bool isOn = glm::dot(normal, glm::dvec3(map_.elements[i].normal)) > minSameWay &&
                                  std::abs(glm::dot(normal, place - middle)) <= maxDistanceM;
                if (isOn && isInside(rings, axes, place)) found.push_back(i);
            }
        }
    return found;
}

SurfaceHours sumHours(const ElementMap& map, const std::vector<std::size_t>& points) {
    SurfaceHours hours{.points = points.size()};
    if (points.empty()) return hours;
    hours.least = std::numeric_limits<double>::max();
    for (const std::size_t i : points) {
        const double sun = map.elements[i].sunlitMin / 60;
        hours.mean += sun / double(points.size());
        hours.least = std::min(hours.least, sun);
        hours.most = std::max(hours.most, sun);
    }
    return hours;
}

}  // namespace noonmark
