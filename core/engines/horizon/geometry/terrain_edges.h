#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/city/terrain/terrain.h"
#include "core/engines/horizon/geometry/shadow_axes.h"

namespace noonmark {

/// The terrain as an occluder: the edges of its triangles (meshOf of a terrain, the surface that rays hit).
/// At one azimuth an edge counts if its far side is lit and its near side is not; the terrain ends vertically
/// at its outer posts. Searched square by square, since most squares are too flat, too low or too far away to
/// hide a bin's suns.
class TerrainEdges {
public:
    static constexpr int side = 32;  ///< side of a square, in terrain cells

    /// `receivers`: the grid in whose cells edges are given. `datumM`: local z from which heights are
    /// measured.
    TerrainEdges(std::shared_ptr<const Terrain> terrain, const Grid& receivers, double datumM);

    /// An edge in the axes of an azimuth; heights in metres above the datum.
    struct Edge {
        ShadowAxes::Point a, b;
        double aM, bM;
    };

    /// A query for one azimuth: edges that can hide a sun of `lowestTan` or higher from a cell of `tile` at
    /// the datum or above.
    struct Question {
        ShadowAxes axes;
        glm::dvec2 away;
        ShadowExtent tile;
        double lowestTan = 0;
        double alongPerMetre = 1;
    };
    /// Replaces the contents of `edges`; incomplete if stopped. Some 3 ns per cell of the squares searched.
    void find(const Question& question, std::vector<Edge>& edges, const std::stop_token& stop) const;

private:
    /// Posts [first, last] of the terrain's grid, corners included, with upper bounds of height and slope.
    struct Square {
        glm::ivec2 first, last;
        float highestM, steepest;
        glm::dvec2 low, high;   ///< bounding box of its posts, in receiver cells
        PostGrid::Steps steps;  ///< steps at its centre, metres
    };
    class Finder;

    [[nodiscard]] double heightM(int column, int row) const;
    [[nodiscard]] glm::dvec2 cellsOf(glm::ivec2 post) const;
    [[nodiscard]] Square squareFrom(glm::ivec2 first) const;
    void setHeights(Square& square) const;
    void setPlace(Square& square) const;

    std::shared_ptr<const Terrain> terrain_;
    glm::dvec2 origin_;  // centre of the receivers' first cell, local metres
    double cellM_ = 1;   // of the receivers
    double datumM_ = 0;
    std::vector<Square> squares_;
};

}  // namespace noonmark
