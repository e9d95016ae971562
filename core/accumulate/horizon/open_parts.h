#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/horizon_code.h"
#include "core/accumulate/horizon/receiver_blocks.h"
#include "core/accumulate/horizon/shadow_axes.h"
#include "core/city/building.h"

namespace noonmark {

/// A triangle of a part that hangs: x and y in cells, z in metres above the datum.
using OpenTriangle = std::array<glm::dvec3, 3>;

/// The triangles of a part. `datumM`: local z that heights count from.
void addTriangles(const Part& part, const Grid& grid, double datumM, std::vector<OpenTriangle>& triangles);

/// The receivers of a tile, cell by cell.
struct OpenTile {
    TileBox box;
    std::vector<std::int32_t> numbers;  ///< row by row; -1 where there is no receiver
    std::vector<float> groundsM;        ///< of each number, above the datum; empty: all lie on it

    OpenTile() = default;
    OpenTile(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM);
};

/// Suns that a receiver does not see though they stand above its horizon: low <= code < high.
struct Gap {
    std::uint32_t number;  ///< of the receiver
    HorizonCode low, high;
};

/// What hides the sun at one azimuth without standing on the ground like a wall. Seen from a receiver each
/// triangle hides the altitudes between its two crossings with the vertical plane through the sun: exactly
/// those whose ray it would stop. One for each thread.
class OpenSweep {
public:
    /// Both outlive it.
    OpenSweep(std::span<const OpenTriangle> triangles, const OpenTile& tile)
        : triangles_(triangles), tile_(tile) {}

    /// `codes`: of the horizons of what stands. Raises them where a part hides all from the horizon up;
    /// returns the rest, receiver by receiver in ascending order, disjoint and apart. About 10 ns a triangle
    /// and shaded cell.
    std::vector<Gap> sweep(glm::dvec2 away, HorizonCode lowest, double cellM, std::span<HorizonCode> codes,
                           const std::stop_token& stop);

private:
    void add(const OpenTriangle& triangle, const ShadowAxes& axes);
    void addLine(int along, HorizonCode most, const ShadowAxes& axes);
    void addCell(std::int32_t number, double q, double along);
    void merge();

    struct Corner {
        double q, along, rise;
    };
    std::span<const OpenTriangle> triangles_;
    const OpenTile& tile_;
    double alongPerMetre_ = 0, lowestTan_ = 0;
    HorizonCode lowest_ = 0;
    std::span<HorizonCode> codes_;
    std::array<Corner, 3> corners_{};  // of the triangle at hand, by q
    std::vector<Gap> gaps_;
    std::size_t merged_ = 0;
};

}  // namespace noonmark
