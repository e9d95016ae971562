#include "core/receivers/points/wall_finder.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace noonmark {

namespace {

constexpr double wallSquareM = 16;
long wallSquareOf(double metres) { return long(std::floor(metres / wallSquareM)); }

// The place of the face's rectangle that is nearest; of a mesh's face, only where the face is.
std::optional<glm::dvec3> footOn(const WallFace& face, glm::dvec3 place) {
    const double along = std::clamp(glm::dot(glm::dvec2(place) - face.start, face.along), 0.0, face.lengthM);
    const double height = std::clamp(place.z, face.lowM, face.highM);
    if (!face.covers({along, height})) return std::nullopt;
    return glm::dvec3(face.start + along * face.along, height);
}

}  // namespace

WallFinder::WallFinder(const City& city) {
    for (std::uint32_t building = 0; building < city.buildings.size(); ++building)
        for (const Part& part : city.buildings[building]->parts)
            for (WallFace& face : findWallFaces(part)) add(std::move(face), building);
}

// In all squares of the box around the wall, as wide as walls are found.
void WallFinder::add(WallFace face, std::uint32_t building) {
    const glm::dvec2 a = face.start, b = face.start + face.lengthM * face.along;
    const glm::dvec2 low = glm::min(a, b) - farthestM, high = glm::max(a, b) + farthestM;
    for (long x = wallSquareOf(low.x); x <= wallSquareOf(high.x); ++x)
        for (long y = wallSquareOf(low.y); y <= wallSquareOf(high.y); ++y)
            squares_[{x, y}].push_back(std::uint32_t(walls_.size()));
    walls_.push_back({std::move(face), building});
}

std::optional<NearWall> WallFinder::nearest(glm::dvec3 place) const {
    std::optional<NearWall> best;
    const auto square = squares_.find({wallSquareOf(place.x), wallSquareOf(place.y)});
    if (square == squares_.end()) return best;
    for (const std::uint32_t index : square->second) {
        const Wall& wall = walls_[index];
        const auto foot = footOn(wall.face, place);
        if (!foot) continue;
        const double distance = glm::length(*foot - place);
        if (distance <= (best ? best->distanceM : farthestM))
            best = NearWall{wall.building, *foot, wall.face.normal(), distance};
    }
    return best;
}

}  // namespace noonmark
