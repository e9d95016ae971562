#include "core/city/terrain/tin_terrain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "core/city/footprints/footprint.h"
#include "core/city/terrain/post_grid.h"

namespace noonmark {

namespace {

constexpr double maxCells = 16e6;

struct Coverage {
    Box2 box;
    double areaM2 = 0;
    std::unordered_set<std::uint32_t> points;
};

Coverage coverageOf(const TriangleMesh& tin) {
    Coverage coverage;
    for (const glm::uvec3 t : tin.triangles) {
        Ring ring;
        for (int i = 0; i < 3; ++i) {
            ring.emplace_back(tin.vertices[t[i]]);
            coverage.box.add(ring.back());
            coverage.points.insert(t[i]);
        }
        coverage.areaM2 += std::abs(signedArea(ring));
    }
    return coverage;
}

// Twice as fine as the points; the outermost cell centres lie within the box, so that triangles reach them.
Grid gridOver(const Coverage& coverage) {
    const glm::dvec2 size = glm::dvec2(coverage.box.high) - glm::dvec2(coverage.box.low);
    const double spacing =
        std::sqrt(coverage.areaM2 / double(std::max<std::size_t>(1, coverage.points.size())));
    double cell = std::clamp(spacing / 2, 0.5, 100.0);
    cell = std::max(cell, std::sqrt(size.x * size.y / maxCells));
    Grid grid{.cellM = cell, .columns = int(size.x / cell) + 1, .rows = int(size.y / cell) + 1};
    grid.westM = (double(coverage.box.low.x) + double(coverage.box.high.x) - grid.columns * cell) / 2;
    grid.southM = (double(coverage.box.low.y) + double(coverage.box.high.y) - grid.rows * cell) / 2;
    return grid;
}

// Barycentric coordinates of a point in a triangle; negative outside.
struct Barycentric {
    glm::dvec3 a, b, c;
    double doubledArea;
    Barycentric(glm::dvec3 first, glm::dvec3 second, glm::dvec3 third)
        : a(first), b(second), c(third), doubledArea(cross(b, c, a)) {}
    static double cross(glm::dvec3 p, glm::dvec3 q, glm::dvec3 r) {
        return (p.x - r.x) * (q.y - r.y) - (p.y - r.y) * (q.x - r.x);
    }

    // NaN outside.
    [[nodiscard]] double elevationAt(glm::dvec2 at) const {
        const glm::dvec3 p(at, 0);
        const glm::dvec3 share = glm::dvec3(cross(b, c, p), cross(c, a, p), cross(a, b, p)) / doubledArea;
        constexpr double edge = -1e-9;  // a centre on a shared edge belongs to both triangles
        const bool inside = share.x >= edge && share.y >= edge && share.z >= edge;
        return inside ? share.x * a.z + share.y * b.z + share.z * c.z
                      : std::numeric_limits<double>::quiet_NaN();
    }
};

int clampedCell(double position, int count) { return int(std::clamp(position, 0.0, double(count - 1))); }

void rasterize(const Barycentric& triangle, const Grid& grid, std::vector<float>& elevationM) {
    const auto [west, east] = std::minmax({triangle.a.x, triangle.b.x, triangle.c.x});
    const auto [south, north] = std::minmax({triangle.a.y, triangle.b.y, triangle.c.y});
    const int lastColumn = clampedCell((east - grid.westM) / grid.cellM, grid.columns);
    const int lastRow = clampedCell((north - grid.southM) / grid.cellM, grid.rows);
    for (int row = clampedCell((south - grid.southM) / grid.cellM - 1, grid.rows); row <= lastRow; ++row)
        for (int column = clampedCell((west - grid.westM) / grid.cellM - 1, grid.columns);
             column <= lastColumn; ++column) {
            const float elevation = float(triangle.elevationAt(grid.centre(column, row)));
            float& cell = elevationM[grid.index(column, row)];
            if (std::isnan(cell) || elevation > cell) cell = std::isnan(elevation) ? cell : elevation;
        }
}

// Records how far the grid's surface deviates from the triangles' own points.
void describe(const Coverage& coverage, const TriangleMesh& tin, TinTerrain& result) {
    TerrainSource& source = result.terrain.source;
    source.method = TerrainMethod::triangulated;
    source.sourcePoints = coverage.points.size();
    source.filled = result.filled;
    double squares = 0;
    for (const std::uint32_t point : coverage.points) {
        const glm::dvec3 vertex(tin.vertices[point]);
        const double off = std::abs(vertex.z - double(elevationAt(result.terrain, glm::dvec2(vertex))));
        squares += off * off;
        source.heightMaxM = std::max(source.heightMaxM, off);
    }
    source.heightRmsM = std::sqrt(squares / double(coverage.points.size()));
}

}  // namespace

std::optional<TinTerrain> rasterizeTin(const TriangleMesh& tin) {
    const Coverage coverage = coverageOf(tin);
    if (coverage.box.empty() || coverage.areaM2 <= 0) return std::nullopt;
    const Grid grid = gridOver(coverage);
    TinTerrain result{{grid, {}}, 0};
    std::vector<float>& elevations = result.terrain.elevationM;
    elevations.assign(grid.size(), std::numeric_limits<float>::quiet_NaN());
    for (const glm::uvec3 t : tin.triangles) {
        const Barycentric triangle(glm::dvec3(tin.vertices[t.x]), glm::dvec3(tin.vertices[t.y]),
                                   glm::dvec3(tin.vertices[t.z]));
        if (triangle.doubledArea != 0) rasterize(triangle, grid, elevations);
    }
    result.filled = fillGaps(elevations, grid.columns, grid.rows);
    if (std::isnan(elevations[0])) return std::nullopt;
    describe(coverage, tin, result);
    return result;
}

}  // namespace noonmark
