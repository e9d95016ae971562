#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/piece_bounds.h"
#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/geometry/wall_list.h"

namespace noonmark {

/// A piece of what hides the sun, the top of a wall that faces away from it or an edge of a roof or of the
/// terrain, in the axes of one azimuth: at most 32 cells across and 16 along. They are cut at places of their
/// own, whatever the tile and the azimuth, and each cut belongs to one side.
struct WallPiece {
    glm::dvec2 low, high;  ///< its ends, across and along: it shades cells from low's q up to before high's
    double lowQ, highQ;    ///< of the ends; along the middle of a batch highQ may lie below lowQ
    float highAlong;       ///< highest `along` of the piece
    float rise;  ///< height at lowQ, such that rise / (distance in `along`) is the tangent of the horizon
    float riseSlope;  ///< of `rise` against q; 0 for walls
    float highRise;   ///< highest of the piece
    float topM;       ///< height above the datum; walls only
    float nearest;    ///< it shades cells farther off than computeNearestAlong(); below 0 where a cell on the
                    ///< wall is behind it
    std::uint32_t building;
};

/// Azimuths that are looked at together: the `k` of each (shadow_axes.h) is off that of these axes by
/// `spread` at most.
struct AzimuthBatch {
    ShadowAxes axes;
    double spread = 0;
};

/// The pieces of wall that matter to a tile at one azimuth, or at any of a batch, in bands of q and, from the
/// sun's far end of the tile towards the sun, in rows of 16 `along`: those that a cell may see first come
/// first.
class BinWalls {
public:
    static constexpr double bandWidth = 48;  // as wide as a piece may be in q
    static constexpr double rowDepth = 16;

    /// Replaces what is there by what these obstacles hide the sun with. `tile`: cells that matter. `cellM`:
    /// metres a cell. `lowestTan`: of the bin's suns. Less once stopped: a large terrain takes long to look
    /// through.
    void find(const WallList& list, const Obstacles& obstacles, glm::dvec2 away, const ShadowExtent& tile,
              double cellM, float lowestTan, const std::stop_token& stop);

    /// The same of prisms for all azimuths of a batch. `lowestTan`: a sun of that altitude in the batch's
    /// middle throws shadows as far along as the lowest of its suns.
    void find(const WallList& list, std::span<const StandingPrism> prisms, const AzimuthBatch& batch,
              const ShadowExtent& tile, double cellM, float lowestTan);

    /// Row of the walls with the highest `along` up to this one; rows count towards the sun.
    [[nodiscard]] int rowOf(double along) const;
    [[nodiscard]] int rows() const { return rows_; }
    /// The first row that any are in; 0 or more.
    [[nodiscard]] int firstRow() const { return firstRow_; }
    /// Highest `along` in a row.
    [[nodiscard]] double highestAlong(int row) const { return (lastStep_ - row + 1) * rowDepth; }

    /// The bands whose pieces may shade lowQ <= q < highQ.
    struct Bands {
        int first, end;
    };
    [[nodiscard]] Bands bandsOf(double lowQ, double highQ) const;
    /// The same of pieces in this row, along all azimuths of a batch, for cells up to this `along`.
    [[nodiscard]] Bands bandsOf(double lowQ, double highQ, double highestAlong, int row) const;
    [[nodiscard]] std::span<const WallPiece> pieces(int row, const Bands& bands) const;
    /// Calls visit(piece) for those in a row that may raise horizons of a block; `sight`: from makeQuery().
    template <class Visit>
    void forEachCandidate(int row, const Bands& bands, const BlockQuery& sight, const Visit& visit) const {
        const auto [first, end] = rangeOf(row, bands);
        for (std::size_t some = first; some < end; some += PieceBounds::together)
            for (std::uint32_t may = bounds_.mayRaise(some, end, sight); may != 0; may &= may - 1)
                visit(sorted_[some + std::size_t(std::countr_zero(may))]);
    }
    /// Of a block with these bounds.
    [[nodiscard]] BlockQuery makeQuery(double lowQ, double highQ, double lowestAlong, float cot) const {
        return {float(lowQ - tile_.lowQ), float(highQ - tile_.lowQ), float(lowestAlong - tile_.lowAlong), cot,
                float(spread_)};
    }
    /// Rise of the tallest piece in this row and all farther ones.
    [[nodiscard]] float tallest(int row, const Bands& bands) const { return highest(tallest_, row, bands); }
    /// Rise of the tallest piece in this row.
    [[nodiscard]] float tallestIn(int row, const Bands& bands) const {
        return highest(tallestIn_, row, bands);
    }
    /// Prisms and solids.
    [[nodiscard]] std::uint64_t outOfReach() const { return outOfReach_; }

private:
    /// One end of what is cut into pieces.
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
    std::vector<std::uint32_t> starts_;  // of each slot: row by row, in it band by band
    std::vector<float> tallestIn_, tallest_;
    std::vector<float> backLit_;             // of the faces of the solid at hand
    std::vector<TerrainEdges::Edge> edges_;  // of the terrain
};

}  // namespace noonmark
