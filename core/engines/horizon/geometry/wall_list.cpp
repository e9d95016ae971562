#include "core/engines/horizon/geometry/wall_list.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>

#include "core/engines/ray/ray_scene.h"

namespace noonmark {

namespace {

/// One side of a triangle, to be matched with the same side of the adjacent triangle.
struct WallSide {
    std::uint32_t low, high;  // indices of the ends
    std::uint32_t face;
    bool forward;  // the triangle runs from low to high
};

std::vector<WallSide> sortedSides(const TriangleMesh& mesh) {
    std::vector<WallSide> sides;
    sides.reserve(mesh.triangles.size() * 3);
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face)
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = mesh.triangles[face][i], b = mesh.triangles[face][(i + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), face, a < b});
        }
    std::ranges::sort(sides, [](const WallSide& a, const WallSide& b) {
        return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
    });
    return sides;
}

// Whether the faces are halves of one plane face, up to rounding.
bool isFlat(glm::vec3 one, glm::vec3 other) {
    constexpr float minimum = 1e-6F;  // radians
    return glm::dot(one, other) > 0 && glm::length(glm::cross(one, other)) < minimum;
}

// A side where more than two faces meet is treated as a boundary of each.
void addEdges(const WallSide* first, const WallSide* end, StandingSolid& solid) {
    if (end - first == 2 && first[0].forward != first[1].forward) {
        if (isFlat(solid.normals[first[0].face], solid.normals[first[1].face])) return;
        const bool forward = first[0].forward;
        solid.edges.push_back(
            {first->low, first->high, first[forward ? 0 : 1].face, first[forward ? 1 : 0].face});
        return;
    }
    for (const WallSide* side = first; side != end; ++side)
        solid.edges.push_back({side->forward ? side->low : side->high, side->forward ? side->high : side->low,
                               side->face, SolidEdge::noFace});
}

}  // namespace

StandingSolid makeStandingSolid(const TriangleMesh& mesh, std::uint32_t building, const Grid& grid,
                                double datumM) {
    StandingSolid solid{.building = building,
                        .topM = std::numeric_limits<float>::lowest(),
                        .low = glm::dvec2(1e30),
                        .high = glm::dvec2(-1e30)};
    for (const glm::vec3 vertex : mesh.vertices) {
        const glm::dvec2 cells{(double(vertex.x) - grid.westM) / grid.cellM - 0.5,
                               (double(vertex.y) - grid.southM) / grid.cellM - 0.5};
        solid.vertices.emplace_back(cells, double(vertex.z) - datumM);
        solid.low = glm::min(solid.low, cells);
        solid.high = glm::max(solid.high, cells);
        solid.topM = std::max(solid.topM, float(double(vertex.z) - datumM));
    }
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        solid.normals.emplace_back(normal / std::max(1e-12, glm::length(normal)));
    }
    const std::vector<WallSide> sides = sortedSides(mesh);
    for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
        while (end < sides.size() && sides[end].low == sides[first].low &&
               sides[end].high == sides[first].high)
            ++end;
        addEdges(sides.data() + first, sides.data() + end, solid);
    }
    return solid;
}

namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// The shortest length of a path that is one step long in columns and rows together: the smaller singular
// value.
double shortestStepM(const PostGrid::Steps& steps) {
    const double a = glm::dot(steps.column, steps.column), b = glm::dot(steps.row, steps.row),
                 c = glm::dot(steps.column, steps.row);
    return std::sqrt((a + b - std::hypot(a - b, 2 * c)) / 2);
}

}  // namespace

TerrainEdges::TerrainEdges(std::shared_ptr<const Terrain> terrain, const Grid& receivers, double datumM)
    : terrain_(std::move(terrain)),
      origin_(receivers.centre(0, 0)),
      cellM_(receivers.cellM),
      datumM_(datumM) {
    // A terrain with a single row or column has no triangles, hence no squares.
    for (int row = 0; row < terrain_->grid.rows - 1; row += side)
        for (int column = 0; column < terrain_->grid.columns - 1; column += side)
            squares_.push_back(squareFrom({column, row}));
}

double TerrainEdges::heightM(int column, int row) const {
    return double(terrain_->elevationM[terrain_->grid.index(column, row)]) - datumM_;
}

glm::dvec2 TerrainEdges::cellsOf(glm::ivec2 post) const {
    return (terrain_->grid.centre(post.x, post.y) - origin_) / cellM_;
}

TerrainEdges::Square TerrainEdges::squareFrom(glm::ivec2 first) const {
    const PostGrid& grid = terrain_->grid;
    Square square{
        .first = first,
        .last = {std::min(first.x + side, grid.columns - 1), std::min(first.y + side, grid.rows - 1)}};
    setPlace(square);
    setHeights(square);
    return square;
}

// The sides of a bent grid deviate from straight lines by less than a cell.
void TerrainEdges::setPlace(Square& square) const {
    const PostGrid& grid = terrain_->grid;
    square.low = glm::dvec2(1e300);
    square.high = -square.low;
    for (const glm::ivec2 corner : {square.first, glm::ivec2(square.last.x, square.first.y),
                                    glm::ivec2(square.first.x, square.last.y), square.last}) {
        square.low = glm::min(square.low, cellsOf(corner));
        square.high = glm::max(square.high, cellsOf(corner));
    }
    if (grid.isBent()) {
        square.low -= grid.cellM / cellM_;
        square.high += grid.cellM / cellM_;
    }
    square.steps = grid.stepsAt(glm::dvec2(square.first + square.last) / 2.0);
}

void TerrainEdges::setHeights(Square& square) const {
    const PostGrid& grid = terrain_->grid;
    const glm::ivec2 first = square.first, last = square.last;
    square.highestM = std::numeric_limits<float>::lowest();
    // Includes the next cells to the east and north, because the square owns the edges between.
    const glm::ivec2 beyond(std::min(last.x + 1, grid.columns - 1), std::min(last.y + 1, grid.rows - 1));
    float steepest = 0;
    for (int row = first.y; row <= beyond.y; ++row)
        for (int column = first.x; column <= beyond.x; ++column) {
            const double here = heightM(column, row);
            if (column <= last.x && row <= last.y) square.highestM = std::max(square.highestM, float(here));
            const double east = column < beyond.x ? heightM(column + 1, row) - here : 0,
                         north = row < beyond.y ? heightM(column, row + 1) - here : 0;
            steepest = std::max({steepest, float(std::abs(east)), float(std::abs(north))});
        }
    const bool outer = first.x == 0 || first.y == 0 || last.x == grid.columns - 1 || last.y == grid.rows - 1;
    // A triangle's gradient is that along one column step and one row step combined, up to sqrt(2) times the
    // larger one; steps may differ by one percent from those at the centre.
    square.steepest = outer ? std::numeric_limits<float>::max()
                            : steepest * 1.4143F * 1.01F / float(shortestStepM(square.steps));
}

/// Searches squares at one azimuth.
class TerrainEdges::Finder {
public:
    Finder(const TerrainEdges& edges, const Question& question, std::vector<Edge>& found)
        : edges_(edges), question_(question), found_(found), lowestTan_(float(question.lowestTan)) {}

    void look(const Square& square) {
        if (!(square.steepest > lowestTan_) || !inReach(square)) return;
        const auto& [column, row] = square.steps;
        awaySteps_ = glm::vec2(glm::dvec2(cross(question_.away, row), cross(column, question_.away)) /
                               cross(column, row));
        for (int y = square.first.y; y < square.last.y; ++y)
            for (int x = square.first.x; x < square.last.x; ++x) lookAtCell(x, y);
        rims(square);
    }

private:
    [[nodiscard]] bool inReach(const Square& square) const {
        if (square.highestM <= 0) return false;
        ShadowExtent extent;
        extent.addBox(question_.axes, square.low, square.high);
        const double reach = double(square.highestM) * question_.alongPerMetre / question_.lowestTan + 1;
        return extent.highQ > question_.tile.lowQ && extent.lowQ < question_.tile.highQ &&
               extent.lowAlong <= question_.tile.highAlong &&
               extent.highAlong + reach >= question_.tile.lowAlong;
    }

    [[nodiscard]] float elevation(int column, int row) const {
        return edges_.terrain_->elevationM[edges_.terrain_->grid.index(column, row)];
    }

    // backLitBelow() of the two triangles of a cell: below its diagonal and above it.
    struct Faces {
        float lower, upper;
    };
    [[nodiscard]] Faces facesOf(int column, int row) const {
        const float a = elevation(column, row), b = elevation(column + 1, row),
                    c = elevation(column + 1, row + 1), d = elevation(column, row + 1);
        return {awaySteps_.x * (a - b) + awaySteps_.y * (b - c),
                awaySteps_.x * (d - c) + awaySteps_.y * (a - d)};
    }

    // Examines the cell's diagonal, and its eastern and northern sides if there are cells beyond.
    void lookAtCell(int column, int row) {
        const PostGrid& grid = edges_.terrain_->grid;
        const Faces own = facesOf(column, row);
        if (isOutline(own.lower, own.upper, lowestTan_)) add({column, row}, {column + 1, row + 1});
        if (column + 2 < grid.columns && isOutline(own.lower, facesOf(column + 1, row).upper, lowestTan_))
            add({column + 1, row}, {column + 1, row + 1});
        if (row + 2 < grid.rows && isOutline(own.upper, facesOf(column, row + 1).lower, lowestTan_))
            add({column, row + 1}, {column + 1, row + 1});
    }

    void rims(const Square& square) {
        const PostGrid& grid = edges_.terrain_->grid;
        const glm::vec2 east = glm::normalize(glm::vec2(square.steps.row.y, -square.steps.row.x)),
                        north = glm::normalize(glm::vec2(-square.steps.column.y, square.steps.column.x));
        for (int row = square.first.y; row < square.last.y; ++row) {
            if (square.first.x == 0) rim({0, row}, {0, row + 1}, -east, facesOf(0, row).upper);
            if (const int last = grid.columns - 1; square.last.x == last)
                rim({last, row}, {last, row + 1}, east, facesOf(last - 1, row).lower);
        }
        for (int column = square.first.x; column < square.last.x; ++column) {
            if (square.first.y == 0) rim({column, 0}, {column + 1, 0}, -north, facesOf(column, 0).lower);
            if (const int last = grid.rows - 1; square.last.y == last)
                rim({column, last}, {column + 1, last}, north, facesOf(column, last - 1).upper);
        }
    }

    void rim(glm::ivec2 a, glm::ivec2 b, glm::vec2 outward, float inner) {
        if (isOutline(inner, backLitBelow({outward, 0}, glm::vec2(question_.away)), lowestTan_)) add(a, b);
    }

    void add(glm::ivec2 a, glm::ivec2 b) {
        found_.push_back({question_.axes.from(edges_.cellsOf(a)), question_.axes.from(edges_.cellsOf(b)),
                          edges_.heightM(a.x, a.y), edges_.heightM(b.x, b.y)});
    }

    const TerrainEdges& edges_;
    const Question& question_;
    std::vector<Edge>& found_;
    glm::vec2 awaySteps_{};  // the direction of shadows in steps of the square, per metre
    float lowestTan_;
};

void TerrainEdges::find(const Question& question, std::vector<Edge>& edges,
                        const std::stop_token& stop) const {
    edges.clear();
    Finder finder(*this, question, edges);
    for (const Square& square : squares_) {
        if (stop.stop_requested()) return;
        finder.look(square);
    }
}

namespace {

class WallBuilder {
public:
    WallBuilder(const Grid& grid, WallList& list) : grid_(grid), list_(list) {}

    void add(const Part& part, std::uint32_t building) {
        StandingPrism prism{.firstWall = std::uint32_t(list_.walls.size()),
                            .topM = float(double(part.topM) - list_.datumM),
                            .building = building,
                            .low = glm::dvec2(1e30),
                            .high = glm::dvec2(-1e30)};
        addRing(part.footprint.outer, prism);
        for (const Ring& hole : part.footprint.holes) addRing(hole, prism);
        prism.wallCount = std::uint32_t(list_.walls.size()) - prism.firstWall;
        list_.prisms.push_back(prism);
    }

private:
    void addRing(const Ring& ring, StandingPrism& prism) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 a = toCells(ring[i]);
            list_.walls.push_back({a, toCells(ring[(i + 1) % ring.size()])});
            prism.low = glm::min(prism.low, a);
            prism.high = glm::max(prism.high, a);
        }
    }

    // Receivers are offset to the east and north of cell centres by as much as those of the rays, so that
    // none lies on a wall.
    [[nodiscard]] glm::dvec2 toCells(glm::vec2 local) const {
        const glm::dvec2 beside = glm::dvec2(local) - double(RayScene::wallOffsetM);
        return {(beside.x - grid_.westM) / grid_.cellM - 0.5, (beside.y - grid_.southM) / grid_.cellM - 0.5};
    }

    const Grid& grid_;
    WallList& list_;
};

}  // namespace

void addStandingWalls(const Building& building, std::uint32_t number, const Grid& grid, WallList& list,
                      OverhangParts& overhangs) {
    WallBuilder builder(grid, list);
    for (const Part& part : building.parts) {
        if (double(part.topM) <= list.datumM) continue;
        if (part.isOverhanging)
            overhangs.push_back({&part, number});
        else if (part.mesh)
            list.solids.push_back(makeStandingSolid(*part.mesh, number, grid, list.datumM));
        else
            builder.add(part, number);
    }
}

WallList collectStandingObstacles(const City& city, std::span<const std::uint32_t> buildings,
                                  const Receivers& receivers, OverhangParts& overhangs) {
    WallList list{.datumM = lowestGroundM(receivers), .terrainNumber = std::uint32_t(city.buildings.size())};
    for (const std::uint32_t index : buildings)
        addStandingWalls(*city.buildings[index], index, receivers.grid, list, overhangs);
    if (city.terrain)
        list.terrain = std::make_shared<const TerrainEdges>(city.terrain, receivers.grid, list.datumM);
    return list;
}

}  // namespace noonmark
