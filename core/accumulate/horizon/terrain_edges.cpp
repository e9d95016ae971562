#include "core/accumulate/horizon/terrain_edges.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/accumulate/horizon/solid_edges.h"

namespace noonmark {

TerrainEdges::TerrainEdges(std::shared_ptr<const Terrain> terrain, const Grid& receivers, double datumM)
    : terrain_(std::move(terrain)),
      origin_((terrain_->grid.centre(0, 0) - receivers.centre(0, 0)) / receivers.cellM),
      cells_(terrain_->grid.cellM / receivers.cellM),
      datumM_(datumM) {
    // None where there is but one row or column: it has no triangles.
    for (int row = 0; row < terrain_->grid.rows - 1; row += side)
        for (int column = 0; column < terrain_->grid.columns - 1; column += side)
            squares_.push_back(squareFrom({column, row}));
}

double TerrainEdges::heightM(int column, int row) const {
    return double(terrain_->elevationM[terrain_->grid.index(column, row)]) - datumM_;
}

glm::dvec2 TerrainEdges::cellsOf(glm::dvec2 corner) const { return origin_ + corner * cells_; }

TerrainEdges::Square TerrainEdges::squareFrom(glm::ivec2 first) const {
    const Grid& grid = terrain_->grid;
    Square square{
        first,
        glm::ivec2(std::min(first.x + side, grid.columns - 1), std::min(first.y + side, grid.rows - 1)),
        std::numeric_limits<float>::lowest(), 0};
    // With the next cells in the east and north: the square has the edges between.
    const glm::ivec2 beyond(std::min(square.last.x + 1, grid.columns - 1),
                            std::min(square.last.y + 1, grid.rows - 1));
    for (int row = first.y; row <= beyond.y; ++row)
        for (int column = first.x; column <= beyond.x; ++column) {
            const double here = heightM(column, row);
            if (column <= square.last.x && row <= square.last.y)
                square.highestM = std::max(square.highestM, float(here));
            const double east = column < beyond.x ? heightM(column + 1, row) - here : 0,
                         north = row < beyond.y ? heightM(column, row + 1) - here : 0;
            square.steepest = std::max({square.steepest, float(std::abs(east)), float(std::abs(north))});
        }
    const bool outer =
        first.x == 0 || first.y == 0 || square.last.x == grid.columns - 1 || square.last.y == grid.rows - 1;
    // A triangle rises along its two sides on the axes.
    square.steepest =
        outer ? std::numeric_limits<float>::max() : square.steepest * 1.4143F / float(grid.cellM);
    return square;
}

/// Looks through the squares at one azimuth.
class TerrainEdges::Finder {
public:
    Finder(const TerrainEdges& edges, const Question& question, std::vector<Edge>& found)
        : edges_(edges),
          question_(question),
          found_(found),
          away_(question.away),
          lowestTan_(float(question.lowestTan)) {}

    void look(const Square& square) {
        if (!(square.steepest > lowestTan_) || !inReach(square)) return;
        for (int row = square.first.y; row < square.last.y; ++row)
            for (int column = square.first.x; column < square.last.x; ++column) lookAtCell(column, row);
        rims(square);
    }

private:
    [[nodiscard]] bool inReach(const Square& square) const {
        if (square.highestM <= 0) return false;
        ShadowExtent extent;
        extent.addBox(question_.axes, edges_.cellsOf(glm::dvec2(square.first)),
                      edges_.cellsOf(glm::dvec2(square.last)));
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
        const auto cellM = float(edges_.terrain_->grid.cellM);
        return {(away_.x * (a - b) + away_.y * (b - c)) / cellM,
                (away_.x * (d - c) + away_.y * (a - d)) / cellM};
    }

    // Its diagonal, and its sides in the east and in the north where there are cells beyond.
    void lookAtCell(int column, int row) {
        const Grid& grid = edges_.terrain_->grid;
        const Faces own = facesOf(column, row);
        if (isOutline(own.lower, own.upper, lowestTan_)) add({column, row}, {column + 1, row + 1});
        if (column + 2 < grid.columns && isOutline(own.lower, facesOf(column + 1, row).upper, lowestTan_))
            add({column + 1, row}, {column + 1, row + 1});
        if (row + 2 < grid.rows && isOutline(own.upper, facesOf(column, row + 1).lower, lowestTan_))
            add({column, row + 1}, {column + 1, row + 1});
    }

    void rims(const Square& square) {
        const Grid& grid = edges_.terrain_->grid;
        for (int row = square.first.y; row < square.last.y; ++row) {
            if (square.first.x == 0) rim({0, row}, {0, row + 1}, {-1, 0}, facesOf(0, row).upper);
            if (const int last = grid.columns - 1; square.last.x == last)
                rim({last, row}, {last, row + 1}, {1, 0}, facesOf(last - 1, row).lower);
        }
        for (int column = square.first.x; column < square.last.x; ++column) {
            if (square.first.y == 0) rim({column, 0}, {column + 1, 0}, {0, -1}, facesOf(column, 0).lower);
            if (const int last = grid.rows - 1; square.last.y == last)
                rim({column, last}, {column + 1, last}, {0, 1}, facesOf(column, last - 1).upper);
        }
    }

    void rim(glm::ivec2 a, glm::ivec2 b, glm::vec2 outward, float inner) {
        if (isOutline(inner, backLitBelow({outward, 0}, away_), lowestTan_)) add(a, b);
    }

    void add(glm::ivec2 a, glm::ivec2 b) {
        found_.push_back({question_.axes.from(edges_.cellsOf(glm::dvec2(a))),
                          question_.axes.from(edges_.cellsOf(glm::dvec2(b))), edges_.heightM(a.x, a.y),
                          edges_.heightM(b.x, b.y)});
    }

    const TerrainEdges& edges_;
    const Question& question_;
    std::vector<Edge>& found_;
    glm::vec2 away_;
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

}  // namespace noonmark
