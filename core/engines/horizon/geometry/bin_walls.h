#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/geometry/wall_list.h"

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

/// A piece of an occluder's outline: the top of a wall that faces away from the sun, or an edge of a roof or
/// of the terrain, in the axes of one azimuth. At most 32 cells across and 16 along. Pieces are cut at fixed
/// positions, independent of tile and azimuth, and a point on a cut belongs to exactly one piece.
struct WallPiece {
    glm::dvec2 low, high;  ///< ends, across and along: shades cells with low's q <= q < high's q
    double lowQ, highQ;    ///< q of the ends; at the middle of a batch highQ may be less than lowQ
    float highAlong;       ///< highest `along` of the piece
    float rise;            ///< height at lowQ, scaled: rise / (distance in `along`) is the horizon's tangent
    float riseSlope;       ///< change of `rise` per q; 0 for walls
    float highRise;        ///< highest `rise` of the piece
    float topM;            ///< height above the datum; walls only
    float nearest;  ///< shades cells farther away than computeNearestAlong(); negative if a cell on the
                    ///< wall lies behind it
    std::uint32_t building;
};

/// Azimuths that are processed together. The `k` of each (shadow_axes.h) differs from that of these axes by
/// at most `spread`.
struct AzimuthBatch {
    ShadowAxes axes;
    double spread = 0;
};

/// The pieces of wall that matter to a tile at one azimuth, or at any azimuth of a batch. They are sorted
/// into rows of 16 `along`, from the tile's far end towards the sun, and within a row into bands of q. Pieces
/// that a cell may see first come first.
class BinWalls {
public:
    static constexpr double bandWidth = 48;  // the largest extent of a piece in q
    static constexpr double rowDepth = 16;

    /// Replaces the contents by the pieces with which these obstacles may hide the sun. `tile`: extent of the
    /// receivers. `cellM`: metres per cell. `lowestTan`: of the bin's suns. Incomplete if stopped, because
    /// searching a large terrain takes long.
    void find(const WallList& list, const Obstacles& obstacles, glm::dvec2 away, const ShadowExtent& tile,
              double cellM, float lowestTan, const std::stop_token& stop);

    /// The same for prisms and all azimuths of a batch. `lowestTan`: a sun of that altitude at the batch's
    /// middle azimuth casts shadows as far along as the lowest of its suns.
    void find(const WallList& list, std::span<const StandingPrism> prisms, const AzimuthBatch& batch,
              const ShadowExtent& tile, double cellM, float lowestTan);

    /// The row of walls whose highest `along` is at most this; row numbers increase towards the sun.
    [[nodiscard]] int rowOf(double along) const;
    [[nodiscard]] int rows() const { return rows_; }
    /// First row that contains walls; at least 0.
    [[nodiscard]] int firstRow() const { return firstRow_; }
    /// Highest `along` in a row.
    [[nodiscard]] double highestAlong(int row) const { return (lastStep_ - row + 1) * rowDepth; }

    /// Bands whose pieces may shade lowQ <= q < highQ.
    struct Bands {
        int first, end;
    };
    [[nodiscard]] Bands bandsOf(double lowQ, double highQ) const;
    /// The same for pieces in this row, at all azimuths of a batch, for cells up to `highestAlong`.
    [[nodiscard]] Bands bandsOf(double lowQ, double highQ, double highestAlong, int row) const;
    [[nodiscard]] std::span<const WallPiece> pieces(int row, const Bands& bands) const;
    /// Calls visit(piece) for each piece of a row that may raise horizons of a block; `sight`: from
    /// makeQuery().
    template <class Visit>
    void forEachCandidate(int row, const Bands& bands, const BlockQuery& sight, const Visit& visit) const {
        const auto [first, end] = rangeOf(row, bands);
        for (std::size_t some = first; some < end; some += PieceBounds::together)
            for (std::uint32_t may = bounds_.mayRaise(some, end, sight); may != 0; may &= may - 1)
                visit(sorted_[some + std::size_t(std::countr_zero(may))]);
    }
    /// Query for a block with these bounds.
    [[nodiscard]] BlockQuery makeQuery(double lowQ, double highQ, double lowestAlong, float cot) const {
        return {float(lowQ - tile_.lowQ), float(highQ - tile_.lowQ), float(lowestAlong - tile_.lowAlong), cot,
                float(spread_)};
    }
    /// Largest rise in this row and all rows farther away.
    [[nodiscard]] float tallest(int row, const Bands& bands) const { return highest(tallest_, row, bands); }
    /// Largest rise in this row.
    [[nodiscard]] float tallestIn(int row, const Bands& bands) const {
        return highest(tallestIn_, row, bands);
    }
    /// Number of prisms and solids out of reach.
    [[nodiscard]] std::uint64_t outOfReach() const { return outOfReach_; }

private:
    /// One end of an outline segment to be cut into pieces.
    struct End {
        glm::dvec2 at;  ///< across and along
        double rise;
    };
    void begin(const AzimuthBatch& batch, const ShadowExtent& tile, double cellM, float lowestTan);
    [[nodiscard]] bool inReach(const ShadowExtent& extent, double reach) const;
    [[nodiscard]] bool facesAway(glm::dvec2 a, glm::dvec2 b) const;
    [[nodiscard]] bool reachesTile(glm::dvec2 low, glm::dvec2 high, double rise);
    [[nodiscard]] glm::dvec2 from(glm::dvec2 cells) const;
    [[nodiscard]] double qOf(glm::dvec2 at) const { return at.x - axes_.k * at.y; }
    void addPrism(const WallList& list, const StandingPrism& prism);
    void addSolid(const StandingSolid& solid, glm::vec2 away);
    void addEdge(const StandingSolid& solid, const SolidEdge& edge);
    void addTerrain(const TerrainEdges& terrain, std::uint32_t number, glm::dvec2 away,
                    const std::stop_token& stop);
    void addUpwards(const End& a, const End& b, const WallPiece& piece);
    void addPieces(const End& a, const End& b, WallPiece piece);
    void setRises(const End& a, const End& b, WallPiece& piece) const;
    void sort();
    void put(const WallPiece& piece, std::size_t at);
    struct Range {
        std::size_t first, end;
    };
    [[nodiscard]] Range rangeOf(int row, const Bands& bands) const;
    [[nodiscard]] float highest(const std::vector<float>& rises, int row, const Bands& bands) const;
    [[nodiscard]] std::size_t slotOf(const WallPiece& piece) const;

    ShadowExtent tile_;
    ShadowAxes axes_{{0, 1}};
    double alongPerMetre_ = 0, lowestTan_ = 0, reach_ = 0, spread_ = 0;
    int firstBand_ = 0, bands_ = 0, lastStep_ = 0, rows_ = 0, firstRow_ = 0;
    std::uint64_t outOfReach_ = 0;
    std::vector<WallPiece> found_, sorted_;
    PieceBounds bounds_;                 // of sorted_
    std::vector<std::uint32_t> starts_;  // start of each slot in sorted_: by row, then band
    std::vector<float> tallestIn_, tallest_;
    std::vector<float> backLit_;             // for each face of the current solid
    std::vector<TerrainEdges::Edge> edges_;  // of the terrain
};

}  // namespace noonmark
