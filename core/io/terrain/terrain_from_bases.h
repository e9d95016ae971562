#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/city/building.h"
#include "core/city/terrain/terrain.h"

namespace noonmark {

/// A building and local z of the ground that its data says it stands on, the earth's curvature still in it.
struct BasedBuilding {
    const Building* building;
    float groundM;
};

/// How the bases of neighbours differ: of buildings that a Delaunay triangulation of their middles joins, at
/// most 100 m apart.
struct BaseRelief {
    static constexpr double neighboursM = 100, unevenM = 1, mattersShare = 0.05;
    std::size_t pairs = 0;
    std::size_t uneven = 0;  ///< that differ by more than 1 m
    double mostM = 0;        ///< the largest difference
    /// Flat ground would move shadows: more than one pair in twenty is uneven.
    [[nodiscard]] bool matters() const { return double(uneven) > mattersShare * double(pairs); }
};
BaseRelief measureRelief(std::span<const BasedBuilding> buildings);

/// "120 of 400 pairs of neighbours within 100 m stand more than 1 m apart in height, 12.3 m at most"
std::string textOf(const BaseRelief& relief);

/// A terrain of triangles between the corners of what stands on the ground, each at its building's base (the
/// lower one where two meet), as a grid over their box: between buildings interpolated, outside the hull the
/// nearest elevation. The earth's curvature is taken off. Nothing where the corners lie on one line.
/// O(corners log corners).
std::optional<Terrain> interpolateBases(std::span<const BasedBuilding> buildings);

}  // namespace noonmark
