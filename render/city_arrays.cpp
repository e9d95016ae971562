#include "render/city_arrays.h"

#include <algorithm>

#include "render/feature_edges.h"

namespace noonmark {

namespace {

void addBuildings(CityArrays& arrays, const City& city, std::size_t mostEdgeTriangles) {
    const CityMesh mesh = meshOf(city);
    arrays.points = mesh.mesh.vertices;
    arrays.buildingOfPoint.resize(arrays.points.size());
    arrays.triangles.reserve(mesh.mesh.triangles.size() * 3);
    for (std::size_t i = 0; i < mesh.mesh.triangles.size(); ++i)
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t point = mesh.mesh.triangles[i][corner];
            arrays.triangles.push_back(point);
            arrays.buildingOfPoint[point] = float(mesh.buildingOfTriangle[i]);
        }
    if (mesh.mesh.triangles.size() <= mostEdgeTriangles) arrays.edges = featureEdges(mesh.mesh);
}

// Beyond the city the ground goes on until it fades into the background.
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

}  // namespace

CityArrays arraysOf(const City& city, std::size_t mostEdgeTriangles) {
    CityArrays arrays;
    arrays.bounds = viewBoundsOf(city);
    addBuildings(arrays, city, mostEdgeTriangles);
    if (city.terrain) addTerrain(arrays, *city.terrain);
    // Below a terrain the square only closes the view towards the horizon.
    const float below = city.terrain ? 0.5F + float(arrays.bounds.radiusM()) * 1e-3F : 0;
    addSquare(arrays, groundBox(arrays.bounds), arrays.bounds.groundM - below);
    return arrays;
}

ViewBounds viewBoundsOf(const City& city) {
    ViewBounds view;
    view.box = bounds(city);
    for (const auto& building : city.buildings) view.topM = std::max(view.topM, topM(*building));
    if (city.terrain) {
        const auto [low, high] = std::ranges::minmax(city.terrain->elevationM);
        view.groundM = low;
        view.topM = std::max(view.topM, high);
        const Grid& grid = city.terrain->grid;
        if (view.box.empty())
            view.box = {{float(grid.westM), float(grid.southM)}, {float(grid.eastM()), float(grid.northM())}};
    }
    if (view.box.empty()) view.box = {{-500, -500}, {500, 500}};
    return view;
}

}  // namespace noonmark
