#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/city/terrain/terrain.h"
#include "core/engines/horizon/geometry/shadow_axes.h"

namespace noonmark {

/// The terrain as what it may hide the sun with: the edges of its triangles (meshOf of a terrain: the surface
/// that rays meet). For one azimuth those count where the far side is lit and the near side is not; what lies
/// beyond the outer posts ends plumb. Looked through square by square: most are too flat, too low or too
/// far for a bin's suns.
class TerrainEdges {
public:
    static constexpr int side = 32;  ///< of a square, in the terrain's cells

    /// `receivers`: the grid whose cells its edges are told in. `datumM`: local z that heights count from.
    TerrainEdges(std::shared_ptr<const Terrain> terrain, const Grid& receivers, double datumM);

    /// An edge in the axes of an azimuth; heights above the datum in metres.
    struct Edge {
        ShadowAxes::Point a, b;
        double aM, bM;
    };

    /// What an azimuth asks for: edges that can hide a sun of `lowestTan` or higher from a cell of `tile` at
    /// the datum or above.
    struct Question {
        ShadowAxes axes;
        glm::dvec2 away;
        ShadowExtent tile;
        double lowestTan = 0;
        double alongPerMetre = 1;
    };
    /// Replaces what is in `edges`; only some of them once stopped. Some 3 ns for each cell of the squares
    /// that are looked through.
    void find(const Question& question, std::vector<Edge>& edges, const std::stop_token& stop) const;

private:
    /// Posts [first, last] of the terrain's grid, corners included, and the most of what is in them.
    struct Square {
        glm::ivec2 first, last;
        float highestM, steepest;
        glm::dvec2 low, high;   ///< the box of its posts, in the receivers' cells
        PostGrid::Steps steps;  ///< in its middle, metres
    };
    class Finder;

    [[nodiscard]] double heightM(int column, int row) const;
    [[nodiscard]] glm::dvec2 cellsOf(glm::ivec2 post) const;
    [[nodiscard]] Square squareFrom(glm::ivec2 first) const;
    void setHeights(Square& square) const;
    void setPlace(Square& square) const;

    std::shared_ptr<const Terrain> terrain_;
    glm::dvec2 origin_;  // the receivers' first centre, local metres
    double cellM_ = 1;   // of the receivers
    double datumM_ = 0;
    std::vector<Square> squares_;
};

}  // namespace noonmark
