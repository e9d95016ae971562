#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/city/city.h"
#include "core/city/meshes/mesh.h"
#include "core/city/terrain/terrain.h"
#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/geo/grid.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// The tangent of the sun's altitude up to which a face with outward unit normal `n` is turned away from a
/// sun that casts shadows in direction `away`. Infinite for vertical faces at the back of the solid and for
/// faces that look down; minus infinite for vertical faces at the front.
inline float backLitBelow(glm::vec3 n, glm::vec2 away) {
    constexpr float plumb = 1e-6F;
    const float forward = n.x * away.x + n.y * away.y;
    if (n.z > plumb) return forward / n.z;
    const float infinite = std::numeric_limits<float>::infinity();
    return n.z < -plumb || forward > 0 ? infinite : -infinite;
}

/// Whether an edge between two faces is part of the outline seen from a sun of this tangent or a higher one.
inline bool isOutline(float oneBackLitBelow, float otherBackLitBelow, float lowestTan) {
    return oneBackLitBelow != otherBackLitBelow &&
           (oneBackLitBelow > lowestTan || otherBackLitBelow > lowestTan);
}

/// An edge of a solid, with the indices of its ends and of the two adjacent faces.
struct SolidEdge {
    static constexpr std::uint32_t noFace = 0xFFFFFFFF;  ///< at the boundary of a surface that is not closed
    std::uint32_t a, b;
    std::uint32_t left, right;  ///< `left` is to the left of a -> b as seen from outside
};

/// A solid that stands on the ground, given by its surface; everything below its faces is solid. The slope of
/// its horizon is determined by the edges between a face that the sun reaches and one that it does not.
struct StandingSolid {
    std::uint32_t building = 0;
    float topM = 0;
    glm::dvec2 low{}, high{};          ///< bounds in cells
    std::vector<glm::dvec3> vertices;  ///< x, y in cells, z in metres above the datum
    std::vector<glm::vec3> normals;    ///< outward, one per face; 0 for a face without area
    std::vector<SolidEdge> edges;      ///< only edges at which the surface bends
};

/// The solid below a mesh. `datumM`: local z from which heights are measured. O(triangles log triangles).
StandingSolid makeStandingSolid(const TriangleMesh& mesh, std::uint32_t building, const Grid& grid,
                                double datumM);

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

/// A wall of a prism that stands on the ground. In cells of a grid: the centre of cell (column, row) is at
/// (column, row).
struct StandingWall {
    glm::dvec2 a, b;  ///< the interior is to the left of a -> b
};

/// The walls of one prism, all of the same height.
struct StandingPrism {
    std::uint32_t firstWall = 0;  ///< index in WallList::walls
    std::uint32_t wallCount = 0;
    float topM = 0;              ///< above the list's datum
    std::uint32_t building = 0;  ///< number given by the caller that adds the building
    glm::dvec2 low{}, high{};    ///< bounds in cells
};

/// Occluders that stand on the ground.
struct WallList {
    double datumM = 0;  ///< local z from which heights are measured
    std::vector<StandingPrism> prisms;
    std::vector<StandingWall> walls;
    std::vector<StandingSolid> solids;            ///< general meshes that stand on the ground
    std::shared_ptr<const TerrainEdges> terrain;  ///< null: flat
    std::uint32_t terrainNumber = 0;              ///< takes the place of a building's number

    [[nodiscard]] std::span<const StandingWall> wallsOf(const StandingPrism& prism) const {
        return std::span(walls).subspan(prism.firstWall, prism.wallCount);
    }
};

/// Some or all of the occluders that a list contains or has contained.
struct Obstacles {
    std::span<const StandingPrism> prisms;  ///< their walls are in the list
    std::span<const StandingSolid> solids;
    const TerrainEdges* terrain = nullptr;

    /// Whether all are prisms on level ground.
    [[nodiscard]] bool even() const { return solids.empty() && terrain == nullptr; }
};
inline Obstacles listAllObstacles(const WallList& list) {
    return {list.prisms, list.solids, list.terrain.get()};
}

/// An overhang, which walls cannot describe.
struct OverhangPart {
    const Part* part;        ///< not owned
    std::uint32_t building;  ///< number given by the caller that adds the building
};
using OverhangParts = std::vector<OverhangPart>;

/// Adds the parts of a building, each extended down to the ground. A part that stands on another part of its
/// building is treated the same way, since the space below it is solid. Overhangs go to `overhangs`, general
/// meshes that stand on the ground to the list's solids; parts that end below the datum are left out.
void addStandingWalls(const Building& building, std::uint32_t number, const Grid& grid, WallList& list,
                      OverhangParts& overhangs);

/// Collects the occluders of the receivers: the parts of these buildings that stand on the ground, numbered
/// by index in the city, and the terrain, whose number is one after the last building's. The datum is the
/// height of the lowest receiver. Overhangs go to `overhangs`.
WallList collectStandingObstacles(const City& city, std::span<const std::uint32_t> buildings,
                                  const Receivers& receivers, OverhangParts& overhangs);

}  // namespace noonmark
