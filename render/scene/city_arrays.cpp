#include "render/scene/city_arrays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>

namespace noonmark {

namespace {

// One side of a triangle, identified by the smaller and the larger of its vertex indices.
struct Side {
    std::uint64_t ends;
    std::uint32_t triangle;
};

std::uint64_t endsOf(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t(std::min(a, b)) << 32) | std::max(a, b);
}

std::vector<Side> sidesOf(const TriangleMesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(mesh.triangles.size() * 3);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        for (int corner = 0; corner < 3; ++corner)
            sides.push_back({endsOf(mesh.triangles[i][corner], mesh.triangles[i][(corner + 1) % 3]), i});
    std::ranges::sort(sides, {}, &Side::ends);
    return sides;
}

glm::vec3 normalOf(const TriangleMesh& mesh, std::uint32_t triangle) {
    const glm::uvec3 corners = mesh.triangles[triangle];
    const glm::vec3 origin = mesh.vertices[corners.x];
    const glm::vec3 normal = glm::cross(mesh.vertices[corners.y] - origin, mesh.vertices[corners.z] - origin);
    const float length = glm::length(normal);
    return length > 0 ? normal / length : glm::vec3(0);
}

// Whether two faces are nearly coplanar and so show no edge between them.
bool isSmooth(const TriangleMesh& mesh, const Side* first, std::size_t faces, float cosine) {
    return faces == 2 &&
           glm::dot(normalOf(mesh, first[0].triangle), normalOf(mesh, first[1].triangle)) > cosine;
}

}  // namespace

std::vector<std::uint32_t> findFeatureEdges(const TriangleMesh& mesh, double angleDeg) {
    const std::vector<Side> sides = sidesOf(mesh);
    const auto cosine = float(std::cos(glm::radians(angleDeg)));
    std::vector<std::uint32_t> edges;
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].ends == sides[i].ends) ++end;
        if (!isSmooth(mesh, &sides[i], end - i, cosine)) {
            edges.push_back(std::uint32_t(sides[i].ends >> 32));
            edges.push_back(std::uint32_t(sides[i].ends));
        }
        i = end;
    }
    return edges;
}

namespace {

// The index in `entries` where each building's entries begin, plus the end of the last building. Entries are
// sorted by building.
std::vector<std::size_t> startsOf(const CityArrays& arrays, const std::vector<std::uint32_t>& entries) {
    std::vector<std::size_t> starts(arrays.buildings.size() + 1, 0);
    for (const std::uint32_t point : entries) ++starts[std::size_t(arrays.buildingOfPoint[point]) + 1];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    return starts;
}

using Shared = std::shared_ptr<const Building>;

std::vector<const Building*> sortedAddresses(const std::vector<Shared>& buildings) {
    std::vector<const Building*> addresses;
    addresses.reserve(buildings.size());
    for (const Shared& building : buildings) addresses.push_back(building.get());
    std::ranges::sort(addresses);
    return addresses;
}

void addBuildings(CityArrays& arrays, const City& city, std::size_t maxEdgeTriangles) {
    const CityMesh mesh = meshOf(city);
    arrays.buildings = city.buildings;
    arrays.points = mesh.mesh.vertices;
    arrays.buildingOfPoint.resize(arrays.points.size());
    arrays.triangles.reserve(mesh.mesh.triangles.size() * 3);
    for (std::size_t i = 0; i < mesh.mesh.triangles.size(); ++i)
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t point = mesh.mesh.triangles[i][corner];
            arrays.triangles.push_back(point);
            arrays.buildingOfPoint[point] = float(mesh.buildingOfTriangle[i]);
        }
    if (mesh.mesh.triangles.size() <= maxEdgeTriangles) arrays.edges = findFeatureEdges(mesh.mesh);
    arrays.triangleStart = startsOf(arrays, arrays.triangles);
    arrays.edgeStart = startsOf(arrays, arrays.edges);
}

// The ground continues beyond the city until it fades into the background.
Box2 groundBox(const ViewBounds& bounds) {
    const glm::vec2 centre(bounds.centre());
    const glm::vec2 reach(float(20 * bounds.radiusM()));
    return {centre - reach, centre + reach};
}

void addSquare(CityArrays& arrays, const Box2& box, float z) {
    const auto first = std::uint32_t(arrays.groundPoints.size());
    arrays.groundPoints.insert(arrays.groundPoints.end(), {{box.low.x, box.low.y, z},
                                                           {box.high.x, box.low.y, z},
                                                           {box.high.x, box.high.y, z},
                                                           {box.low.x, box.high.y, z}});
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
        arrays.groundTriangles.push_back(first + corner);
}

void addTerrain(CityArrays& arrays, const Terrain& terrain) {
    const TriangleMesh mesh = meshOf(terrain);
    arrays.groundPoints = mesh.vertices;
    for (const glm::uvec3 triangle : mesh.triangles)
        arrays.groundTriangles.insert(arrays.groundTriangles.end(), {triangle.x, triangle.y, triangle.z});
}

// The posts along the border, counter-clockwise seen from above.
std::vector<std::uint32_t> listBorder(const PostGrid& grid) {
    std::vector<std::uint32_t> border;
    const auto add = [&](int column, int row) { border.push_back(std::uint32_t(grid.index(column, row))); };
    const int east = grid.columns - 1, north = grid.rows - 1;
    for (int column = 0; column < east; ++column) add(column, 0);
    for (int row = 0; row < north; ++row) add(east, row);
    for (int column = east; column > 0; --column) add(column, north);
    for (int row = north; row > 0; --row) add(0, row);
    return border;
}

// From the border of a terrain the ground falls gently to the plane that surrounds it: a step would throw a
// shadow of its own. The terrain's points are the first ones.
void addSlopeAround(CityArrays& arrays, const Terrain& terrain, float levelM) {
    constexpr float farther = 15;
    const glm::vec2 middle(
        terrain.grid.centre(0.5 * (terrain.grid.columns - 1), 0.5 * (terrain.grid.rows - 1)));
    const std::vector<std::uint32_t> border = listBorder(terrain.grid);
    const auto first = std::uint32_t(arrays.groundPoints.size());
    for (const std::uint32_t post : border)
        arrays.groundPoints.emplace_back(middle + farther * (glm::vec2(arrays.groundPoints[post]) - middle),
                                         levelM);
    const auto count = std::uint32_t(border.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = (i + 1) % count;
        arrays.groundTriangles.insert(arrays.groundTriangles.end(), {border[i], first + i, first + next,
                                                                     border[i], first + next, border[next]});
    }
}

}  // namespace

CityArrays makeBuildingArrays(const City& city, std::size_t maxEdgeTriangles) {
    CityArrays arrays;
    addBuildings(arrays, city, maxEdgeTriangles);
    return arrays;
}

ArrayDifference computeDifference(const CityArrays& drawn, const City& city) {
    ArrayDifference difference;
    const auto before = sortedAddresses(drawn.buildings);
    const auto after = sortedAddresses(city.buildings);
    for (std::size_t i = 0; i < drawn.buildings.size(); ++i)
        if (!std::ranges::binary_search(after, drawn.buildings[i].get()))
            difference.removed.push_back(std::uint32_t(i));
    for (const Shared& building : city.buildings)
        if (!std::ranges::binary_search(before, building.get()))
            difference.added.buildings.push_back(building);
    return difference;
}

CityArrays makeArrays(const City& city, std::size_t maxEdgeTriangles) {
    CityArrays arrays = makeBuildingArrays(city, maxEdgeTriangles);
    arrays.bounds = computeViewBounds(city);
    arrays.mainPart = findMainPart(city);
    arrays.terrain = city.terrain;
    // Below a terrain the square only fills the view up to the horizon.
    const float below = city.terrain ? 0.5F + float(arrays.bounds.radiusM()) * 1e-3F : 0;
    const float levelM = arrays.bounds.groundM - below;
    if (city.terrain) {
        addTerrain(arrays, *city.terrain);
        addSlopeAround(arrays, *city.terrain, levelM);
    }
    addSquare(arrays, groundBox(arrays.bounds), levelM);
    return arrays;
}

ViewBounds computeViewBounds(const City& city) {
    ViewBounds view;
    view.box = bounds(city);
    for (const auto& building : city.buildings) view.topM = std::max(view.topM, topM(*building));
    if (city.terrain) {
        const auto [low, high] = std::ranges::minmax(city.terrain->elevationM);
        view.groundM = low;
        view.topM = std::max(view.topM, high);
        if (view.box.empty()) view.box = bounds(city.terrain->grid);
    }
    if (view.box.empty()) view.box = {{-500, -500}, {500, 500}};
    return view;
}

}  // namespace noonmark
