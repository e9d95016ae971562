#include "core/io/meshes/up_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <optional>

namespace noonmark {

namespace {

bool isFinite(glm::vec3 point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

// The finite points of a scene, in metres. Those in map coordinates are exact to some centimetres.
struct MeshPoints {
    const MeshScene& scene;
    double metresPerUnit = 1;

    template <class Use>
    void forEach(Use use) const {
        for (const MeshObject& object : scene)
            for (const MeshPiece& piece : object.pieces)
                for (const glm::vec3 own : piece.points) {
                    const glm::vec3 point((piece.origin + glm::dvec3(own)) * metresPerUnit);
                    if (isFinite(point)) use(point);
                }
    }
};

struct MeshExtent {
    glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};
    std::size_t points = 0;
    [[nodiscard]] glm::vec3 size() const { return high - low; }
};

MeshExtent measureExtent(const MeshPoints& points) {
    MeshExtent extent;
    points.forEach([&](glm::vec3 point) {
        extent.low = glm::min(extent.low, point), extent.high = glm::max(extent.high, point);
        ++extent.points;
    });
    return extent;
}

// Sizes along an axis that could be up and along the two others.
struct UpSizes {
    UpAxis axis;
    float up, narrow, wide;
};

UpSizes sizesFor(UpAxis axis, glm::vec3 size) {
    const float up = axis == UpAxis::z ? size.z : size.y, other = axis == UpAxis::z ? size.y : size.z;
    return {axis, up, std::min(size.x, other), std::max(size.x, other)};
}

const char* letterOf(UpAxis axis) { return axis == UpAxis::z ? "z" : "y"; }

std::string sizeText(float size) {
    return size < 100 ? fmt::format("{:.3g}", size) : fmt::format("{:.0f}", size);
}

std::optional<UpAxisGuess> guessCity(const UpSizes& sizes) {
    constexpr float minWidth = 100;
    if (sizes.narrow < minWidth || sizes.up >= sizes.narrow / 2) return std::nullopt;
    return UpAxisGuess{sizes.axis,
                       fmt::format("the mesh is {} x {} and only {} in {}", sizeText(sizes.wide),
                                   sizeText(sizes.narrow), sizeText(sizes.up), letterOf(sizes.axis))};
}

std::optional<UpAxisGuess> guessTower(const UpSizes& sizes) {
    if (sizes.up <= 1.5F * sizes.wide) return std::nullopt;
    return UpAxisGuess{sizes.axis,
                       fmt::format("the mesh is {} x {} and {} in {}, as a tower is", sizeText(sizes.wide),
                                   sizeText(sizes.narrow), sizeText(sizes.up), letterOf(sizes.axis))};
}

std::optional<UpAxisGuess> guessByFeet(const MeshPoints& points, const MeshExtent& extent) {
    const glm::vec3 lowest = extent.low + 1e-3F * extent.size();
    std::size_t y = 0, z = 0;
    points.forEach([&](glm::vec3 point) {
        y += point.y <= lowest.y ? 1 : 0;
        z += point.z <= lowest.z ? 1 : 0;
    });
    const auto [fewer, more] = std::minmax(y, z);
    if (5 * more < extent.points || 4 * more < 5 * fewer) return std::nullopt;
    const UpAxis axis = z > y ? UpAxis::z : UpAxis::y;
    return UpAxisGuess{axis, fmt::format("most of its points are lowest in {}", letterOf(axis))};
}

// A flat bottom at 0.
bool standsAtZero(const MeshPoints& points, const MeshExtent& extent, UpAxis axis) {
    const auto along = [&](glm::vec3 point) { return axis == UpAxis::z ? point.z : point.y; };
    const float tolerance = 1e-3F * along(extent.size());
    if (std::abs(along(extent.low)) > tolerance) return false;
    std::size_t feet = 0;
    points.forEach([&](glm::vec3 point) { feet += along(point) <= tolerance ? 1 : 0; });
    return 5 * feet >= extent.points;
}

// Who exchanges the axes of a plan that begins at 0 gets a negative z, which leaves only y at 0.
std::optional<UpAxisGuess> guessByZero(const MeshPoints& points, const MeshExtent& extent) {
    const bool y = standsAtZero(points, extent, UpAxis::y), z = standsAtZero(points, extent, UpAxis::z);
    if (z && !y) return UpAxisGuess{UpAxis::z, "its flat bottom is at 0 in z"};
    if (y && !z) return UpAxisGuess{UpAxis::y, "its flat bottom is at 0 in y"};
    if (y && z) return UpAxisGuess{UpAxis::z, "it begins at 0 in y and z, as a plan with heights does"};
    return std::nullopt;
}

std::optional<UpAxisGuess> guessLower(const MeshPoints&, const MeshExtent& extent) {
    const glm::vec3 size = extent.size();
    if (size.y == size.z) return std::nullopt;
    const UpAxis axis = size.z < size.y ? UpAxis::z : UpAxis::y;
    return UpAxisGuess{
        axis,
        fmt::format("nothing else in its shape tells, and it is lower in {}: {} instead of {}",
                    letterOf(axis), sizeText(std::min(size.y, size.z)), sizeText(std::max(size.y, size.z)))};
}

}  // namespace

UpAxisGuess guessUpAxis(const MeshScene& scene, double metresPerUnit) {
    const MeshPoints points{scene, metresPerUnit};
    const MeshExtent extent = measureExtent(points);
    const UpAxisGuess usual{UpAxis::y, "nothing in its shape says otherwise"};
    if (extent.points == 0) return usual;
    for (const auto guess : {guessCity, guessTower})
        for (const UpAxis axis : {UpAxis::y, UpAxis::z})
            if (auto found = guess(sizesFor(axis, extent.size()))) return *std::move(found);
    for (const auto guess : {guessByFeet, guessByZero, guessLower})
        if (auto found = guess(points, extent)) return *std::move(found);
    return usual;
}

std::optional<UpAxisGuess> guessUpAxisOnMap(const MeshScene& scene, double metresPerUnit) {
    constexpr float leastOnMap = 10'000;  // metres
    const MeshExtent extent = measureExtent({scene, metresPerUnit});
    if (extent.points == 0) return std::nullopt;
    const auto isHeight = [&](float low, float high) { return std::max(-low, high) < leastOnMap; };
    const bool y = isHeight(extent.low.y, extent.high.y), z = isHeight(extent.low.z, extent.high.z);
    if (y == z) return std::nullopt;
    return UpAxisGuess{z ? UpAxis::z : UpAxis::y,
                       fmt::format("its coordinates along {} are those of a map", z ? "y" : "z")};
}

}  // namespace noonmark
