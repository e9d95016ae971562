#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace noonmark {

/// A block's query for pieces of wall: which ones overlap its cells in q and are high enough to be seen above
/// its lowest horizon. In cells, relative to the origin of the bounds.
struct BlockQuery {
    float lowQ, highQ;  ///< bounds of the block's cells
    float lowestAlong;  ///< lowest `along` of its cells
    float cot;          ///< cotangent of its lowest horizon
    float spread = 0;   ///< sideways margin in cells per cell of distance, for a batch of azimuths
};

/// Bounds of pieces of wall, tested sixteen at a time.
class PieceBounds {
public:
    static constexpr std::size_t together = 16;

    /// The bounds of some neighbouring pieces, at least `together`.
    struct Arrays {
        const float *lowQ, *highQ, *highAlong, *rise;
    };

    void resize(std::size_t pieces);
    void set(std::size_t piece, float lowQ, float highQ, float highAlong, float rise);

    /// Returns as bits the pieces [first, first + 16), below `end`, that may raise a horizon. The margin
    /// exceeds rounding: a piece that is excluded changes no bit of the result, in whatever order pieces
    /// come. 5 ns.
    [[nodiscard]] std::uint32_t mayRaise(std::size_t first, std::size_t end, const BlockQuery& sight) const;

private:
    std::vector<float> lowQ_, highQ_, highAlong_, rise_;  // padded by 16 unused entries
};

}  // namespace noonmark
