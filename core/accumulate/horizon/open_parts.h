#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/gaps.h"
#include "core/accumulate/horizon/open_prisms.h"
#include "core/accumulate/horizon/open_triangles.h"
#include "core/accumulate/horizon/receiver_blocks.h"
#include "core/accumulate/horizon/shadow_axes.h"

namespace noonmark {

/// The cells of a tile that have numbers.
struct OpenTile {
    TileBox box;
    std::vector<std::int32_t> numbers;  ///< row by row; -1: none
    std::vector<float> groundsM;        ///< of each number, above the datum; empty: all lie on it
    std::vector<Stretch> squares;       ///< numbers of each square of cells (ReceiverBlocks), row by row

    OpenTile() = default;
    OpenTile(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM);
};

/// What is looked at: triangles, and prisms whole, from the cells of a tile, at one azimuth.
struct OpenView {
    std::span<const OpenTriangle> triangles;
    const OpenTile& tile;
    glm::dvec2 away;
    HorizonCode lowest;  ///< code of the lowest sun: what ends below hides none
    double cellM;
    ShadowExtent within = everywhere;  ///< cells that matter
    std::span<const OpenPrism> prisms{};

    static constexpr ShadowExtent everywhere{-1e300, 1e300, -1e300, 1e300};
};

/// What hides the sun at one azimuth without standing on the ground like a wall. Seen from a receiver each
/// triangle hides the altitudes between its two crossings with the vertical plane through the sun, and each
/// prism those from its far bottom to its near top: exactly those whose ray it would stop. Keeps its memory
/// from one view to the next; one for each thread.
class OpenSweep {
public:
    static constexpr HorizonCode blind = std::numeric_limits<HorizonCode>::max();  ///< no horizon is as high

    /// `horizons`: of what stands, one a number; `blind` for those that do not matter. Returns the intervals
    /// that reach above them, receiver by receiver in ascending order, from below, disjoint and apart; none
    /// once stopped. Valid until the next call. About 10 ns a triangle or prism and shaded cell.
    std::span<const Gap> intervals(const OpenView& view, std::span<const HorizonCode> horizons,
                                   const std::stop_token& stop);

private:
    struct Corner {
        double q, along, rise;
    };
    struct Range {
        double first, last;
    };
    /// The cells of one line, [first, end) across, that lie at lowQ <= q < highQ.
    struct LineCells {
        int line, first, end;
        double shift;  ///< across less q
    };
    void findLines();
    /// Calls visit(along) for the lines [first, last] from which something at lowQ <= q < highQ may be seen
    /// that reaches up to mostAt(along), which falls with the distance. Square by square where no line may.
    template <class MostAt, class Visit>
    void forEachLine(const Range& lines, const Range& q, const MostAt& mostAt, const Visit& visit);
    [[nodiscard]] bool mayBeSeen(const Range& lines, const Range& q, HorizonCode most);
    [[nodiscard]] HorizonCode lowestIn(std::size_t square);
    [[nodiscard]] LineCells cellsOf(int along, double lowQ, double highQ) const;
    [[nodiscard]] std::int32_t numberAt(int line, int across) const;
    [[nodiscard]] double groundOf(std::int32_t number) const;
    void add(const OpenTriangle& triangle);
    void addLine(int along, HorizonCode most);
    void addCell(std::int32_t number, double q, double along);
    void add(const OpenPrism& prism);
    void addLine(const PrismOutline& prism, int along, HorizonCode most);
    void addCell(const PrismOutline& prism, std::int32_t number, double toNear, double toFar);
    void addGap(std::int32_t number, HorizonCode low, HorizonCode high);
    void merge();

    const OpenView* view_ = nullptr;
    ShadowAxes axes_{{0, 1}};
    double alongPerMetre_ = 0, lowestTan_ = 0;
    Range lines_{};  // of the tile, in `along`
    std::span<const HorizonCode> horizons_;
    std::array<Corner, 3> corners_{};  // of the triangle at hand, by q
    PrismOutline outline_;             // of the prism at hand
    OutlineWalk walk_;
    /// The lowest horizon of a square; of the view that it was found in.
    struct SquareLow {
        std::uint64_t view = 0;
        HorizonCode code = 0;
    };
    std::vector<SquareLow> lows_;
    std::uint64_t views_ = 0;
    std::vector<Gap> gaps_;
    std::size_t merged_ = 0;
    GapMerge merge_;
};

template <class MostAt, class Visit>
void OpenSweep::forEachLine(const Range& lines, const Range& q, const MostAt& mostAt, const Visit& visit) {
    constexpr int side = ReceiverBlocks::side;
    const TileBox& box = view_->tile.box;
    const int low = axes_.swapped ? box.firstColumn : box.firstRow, sign = int(axes_.sign);
    for (int along = int(lines.first); double(along) <= lines.last;) {
        const int square = (sign * along - low) / side;
        const int end = sign > 0 ? low + (square + 1) * side : -(low + square * side) + 1;
        const int last = std::min(end - 1, int(lines.last));
        if (mayBeSeen({double(along), double(last)}, q, mostAt(along)))
            for (int line = along; line <= last; ++line) visit(line, mostAt(line));
        along = last + 1;
    }
}

}  // namespace noonmark
