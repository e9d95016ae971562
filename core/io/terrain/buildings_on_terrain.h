#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/city/city.h"
#include "core/city/terrain/terrain.h"

namespace noonmark {

/// A building and the local z of the ground that its data states, not yet lowered by the earth's curvature.
struct BasedBuilding {
    const Building* building;
    float groundM;
};

/// Height differences between the bases of neighbours: buildings at most 100 m apart whose middles are joined
/// by an edge of the Delaunay triangulation.
struct BaseRelief {
    static constexpr double neighboursM = 100, unevenM = 1, mattersShare = 0.05;
    std::size_t pairs = 0;
    std::size_t uneven = 0;  ///< pairs that differ by more than 1 m
    double maxM = 0;         ///< the largest difference
    /// Whether flat ground would move shadows: more than one pair in twenty is uneven.
    [[nodiscard]] bool matters() const { return double(uneven) > mattersShare * double(pairs); }
};
BaseRelief measureRelief(std::span<const BasedBuilding> buildings);

/// "120 of 400 pairs of neighbours within 100 m differ by more than 1 m in ground elevation, by 12.3 m at
/// most"
std::string formatText(const BaseRelief& relief);

/// A terrain of triangles between the corners of the buildings that stand on the ground, each at its
/// building's base (the lower one where two meet), as a grid over their box: interpolated between buildings,
/// the nearest elevation outside the hull. Lowered by the earth's curvature. Nothing if the corners lie on
/// one line. O(corners log corners).
std::optional<Terrain> interpolateBases(std::span<const BasedBuilding> buildings);

/// Moves a building up.
void lift(Building& building, float byM);

/// The lowest ground under a building's outline, local z: of its corners, and of up to 1,024 points inside
/// each part.
float findLowestGround(const Building& building, const Terrain& terrain);

/// Places a building on the ground. With terrain: a building without a stated ground (`groundM`, local z) is
/// lifted as a whole by the lowest ground under it. One with a stated ground is lowered by the earth's
/// curvature (frame.h), and its standing walls are extended down to the terrain where that is lower (a
/// mesh keeps its shape). Without terrain the ground is flat at z = 0, and a stated ground is subtracted.
Building standOnTerrain(Building building, std::optional<float> groundM, const Terrain* terrain);

}  // namespace noonmark
