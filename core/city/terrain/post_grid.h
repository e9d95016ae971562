#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/geo/grid.h"

namespace noonmark {

/// Gives every NaN cell of a row-major grid a value between those of the cells around its gap, without steps:
/// terraces would cast shadows of their own. Returns the number of cells filled; 0 if all cells had values,
/// or none had. O(cells).
std::size_t fillGaps(std::vector<float>& values, int columns, int rows);

/// Posts (points of known elevation) in rows and columns, placed in local metres. The posts are those of a
/// square grid, or a raster's own posts, whose rows deviate from true east by the convergence of its map. Row
/// 0 is the southernmost of a raster with north at its top; the step from row to row points to the left of
/// the step from column to column. Arrays over posts are row-major.
///
/// The position of a post is first + column columnStep + row rowStep + the bend: a polynomial of the second
/// and third degree in u and v, which run from -1 at the first to 1 at the last column and row. The bend
/// expresses the distortion of a map projection within the extent; it is zero if steps alone place the posts
/// well enough.
struct PostGrid {
    static constexpr std::size_t bendTerms = 7;  ///< u2, uv, v2, u3, u2v, uv2, v3
    using Bend = std::array<glm::dvec2, bendTerms>;

    int columns = 0;
    int rows = 0;
    double cellM = 1;  ///< side of a square as large as the middle cell
    glm::dvec2 first{0, 0};
    glm::dvec2 columnStep{1, 0};
    glm::dvec2 rowStep{0, 1};
    Bend bend{};

    PostGrid() = default;
    /// Places a post in the centre of every cell.
    PostGrid(const Grid& grid);  // NOLINT(google-explicit-constructor)
    PostGrid(double westM, double southM, double cellM, int columns, int rows)
        : PostGrid(Grid{westM, southM, cellM, columns, rows}) {}

    [[nodiscard]] std::size_t size() const { return std::size_t(columns) * std::size_t(rows); }
    [[nodiscard]] std::size_t index(int column, int row) const {
        return std::size_t(row) * std::size_t(columns) + std::size_t(column);
    }
    [[nodiscard]] bool isBent() const { return bend != Bend{}; }

    /// Position of a post, or of a point between posts.
    [[nodiscard]] glm::dvec2 centre(double column, double row) const;

    /// The vectors to the next column and the next row at a point between posts.
    struct Steps {
        glm::dvec2 column, row;
    };
    [[nodiscard]] Steps stepsAt(glm::dvec2 columnRow) const;

    /// The inverse of centre(): x = column, y = row. Far outside the posts only approximate; a bent grid
    /// gives positions no farther than half the grid's size beyond it.
    [[nodiscard]] glm::dvec2 columnRowOf(glm::dvec2 point) const;

    /// The nearest position within the columns and rows; a position within them is returned unchanged.
    [[nodiscard]] glm::dvec2 insideOf(glm::dvec2 columnRow) const;

    bool operator==(const PostGrid&) const = default;
};

/// The box of all posts. O(columns + rows).
Box2 bounds(const PostGrid& posts);

/// Distance of a point from the posts' outline, metres; 0 within half a cell of it.
double beyondM(const PostGrid& posts, glm::dvec2 point);

}  // namespace noonmark
