#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/gaps.h"
#include "core/accumulate/horizon/open_triangles.h"
#include "core/accumulate/horizon/receiver_blocks.h"
#include "core/accumulate/horizon/shadow_axes.h"

namespace noonmark {

/// The cells of a tile that have numbers.
struct OpenTile {
    TileBox box;
    std::vector<std::int32_t> numbers;  ///< row by row; -1: none
    std::vector<float> groundsM;        ///< of each number, above the datum; empty: all lie on it

    OpenTile() = default;
    OpenTile(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM);
};

/// What is looked at: triangles from the cells of a tile, at one azimuth.
struct OpenView {
    std::span<const OpenTriangle> triangles;
    const OpenTile& tile;
    glm::dvec2 away;
    HorizonCode lowest;  ///< code of the lowest sun: what ends below hides none
    double cellM;
    ShadowExtent within = everywhere;  ///< cells that matter

    static constexpr ShadowExtent everywhere{-1e300, 1e300, -1e300, 1e300};
};

/// What hides the sun at one azimuth without standing on the ground like a wall. Seen from a receiver each
/// triangle hides the altitudes between its two crossings with the vertical plane through the sun: exactly
/// those whose ray it would stop. Keeps its memory from one view to the next; one for each thread.
class OpenSweep {
public:
    static constexpr HorizonCode blind = std::numeric_limits<HorizonCode>::max();  ///< no horizon is as high

    /// `horizons`: of what stands, one a number; `blind` for those that do not matter. Returns the intervals
    /// that reach above them, receiver by receiver in ascending order, from below, disjoint and apart; none
    /// once stopped. Valid until the next call. About 10 ns a triangle and shaded cell.
    std::span<const Gap> intervals(const OpenView& view, std::span<const HorizonCode> horizons,
                                   const std::stop_token& stop);

private:
    struct Corner {
        double q, along, rise;
    };
    struct Range {
        double first, last;
    };
    void findLines();
    void add(const OpenTriangle& triangle);
    void addLine(int along, HorizonCode most);
    void addCell(std::int32_t number, double q, double along);
    void merge();

    const OpenView* view_ = nullptr;
    ShadowAxes axes_{{0, 1}};
    double alongPerMetre_ = 0, lowestTan_ = 0;
    Range lines_{};  // of the tile, in `along`
    std::span<const HorizonCode> horizons_;
    std::array<Corner, 3> corners_{};  // of the triangle at hand, by q
    std::vector<Gap> gaps_;
    std::size_t merged_ = 0;
    GapMerge merge_;
};

}  // namespace noonmark
