#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace noonmark {

/// What a block wants to know of pieces of wall before it looks closely: those that lie across its cells and
/// are high enough to be seen over its lowest horizon. In cells from the place that bounds count from.
struct BlockQuery {
    float lowQ, highQ;  ///< bounds of its cells
    float lowestAlong;  ///< of its cells
    float cot;          ///< of its lowest horizon
    float spread = 0;   ///< cells aside for each cell of distance, where it looks along a batch of azimuths
};

/// Bounds of pieces of wall, sixteen of which are looked at together.
class PieceBounds {
public:
    static constexpr std::size_t together = 16;

    void resize(std::size_t pieces);
    void set(std::size_t piece, float lowQ, float highQ, float highAlong, float rise);

    /// The pieces [first, first + 16) that may raise a horizon, as bits, those from `end` on left out. Wide
    /// of rounding: a piece that is passed over changes no bit, in whatever order they come. 5 ns.
    [[nodiscard]] std::uint32_t mayRaise(std::size_t first, std::size_t end, const BlockQuery& sight) const;

private:
    std::vector<float> lowQ_, highQ_, highAlong_, rise_;  // and 16 that are nobody's
};

}  // namespace noonmark
