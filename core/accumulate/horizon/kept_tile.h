#pragma once

#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/gap_edit.h"
#include "core/accumulate/horizon/kept_walls.h"
#include "core/accumulate/horizon/period_count.h"

namespace noonmark {

/// Horizons of a tile at one azimuth, exact for suns above `lowest`: what ends at a sun's own level is kept,
/// since a gap that begins one level above is joined to it.
struct KeptBin {
    HorizonCode lowest = 0;
    std::vector<HorizonCode> codes;  ///< of what stands, one a number; none: not there
    std::vector<Gap> gaps;  ///< of receivers, by number: all that hangs and reaches above the horizon

    static HorizonCode below(const AzimuthBin& bin) {
        return HorizonCode(std::max(int(noHorizon), int(bin.lowest()) - 1));
    }
    [[nodiscard]] bool holds(const AzimuthBin& bin) const { return !codes.empty() && lowest <= below(bin); }
};

/// The steps hidden in a tile in the period at hand, and what of the field is out of date.
struct TileCount {
    std::vector<std::uint32_t> hidden;                 ///< one a number
    std::vector<std::vector<HorizonCode>> suns;        ///< that were counted; by bin number
    std::vector<std::uint8_t> grossIsOld, runsAreOld;  ///< one for each 64 numbers
};

/// The horizons of a tile, kept while dates, hours and buildings change.
class KeptTile {
public:
    KeptTile(const Receivers& receivers, const TileBox& box, std::size_t bins);

    [[nodiscard]] const ReceiverBlocks& blocks() const { return blocks_; }
    [[nodiscard]] std::size_t bytes() const;
    void drop();

    /// Sweeps the bins that are not there or do not reach low enough, and counts; of bins whose suns are
    /// those of the period before nothing. Returns how many it swept.
    std::size_t retime(const Receivers& receivers, const KeptWalls& walls, const BinnedSun& binned,
                       const std::stop_token& stop);

    /// After the city changed: other receivers (their ground `groundBeforeM`, as in Receivers), buildings
    /// that went and came. Only horizons that may change are looked at. After a stop the tile is empty.
    void change(const Receivers& receivers, std::span<const float> groundBeforeM, const KeptWalls& walls,
                const WallChange& change, const BinnedSun& binned, const PeriodCount& count, double binDeg,
                const std::stop_token& stop);

    /// Writes the gross minutes that are out of date.
    void writeGross(ShadowField& field, const std::stop_token& stop);

    /// Writes the longest runs that are out of date.
    void writeRuns(const BinnedSun& binned, const PeriodCount& count, ShadowField& field,
                   const std::stop_token& stop);

private:
    struct BinTable {
        std::uint32_t number;
        HiddenSuns hidden;
    };
    struct Sweeping;  // what the threads share while bins are swept
    struct Editing;   // or changed
    std::size_t sweep(const Receivers& receivers, const KeptWalls& walls, const BinnedSun& binned,
                      const std::stop_token& stop);
    void sweep(KeptBin& kept, const AzimuthBin& bin, Sweeping& sweeping) const;
    void lookAtGround(const Receivers& receivers, const KeptWalls& walls, bool hung);
    std::vector<BinTable> tablesFor(const BinnedSun& binned);
    void addHidden(const std::vector<BinTable>& tables, const std::stop_token& stop);
    void addGaps(const BinTable& table, std::size_t first, std::size_t end);
    [[nodiscard]] std::vector<Stretch> stretchesOfReceivers() const;
    void beginNew(const ChangedCells& cells);
    void change(std::uint32_t number, glm::dvec2 away, const HiddenSuns* hidden, Editing& editing);
    void take(std::span<const std::uint32_t> more, std::span<const std::uint8_t> parts);
    void allOld();

    TileBox box_;
    ReceiverBlocks blocks_;
    BlockGrounds grounds_;
    OpenTile open_;              // empty before anything hangs
    std::vector<KeptBin> bins_;  // by number
    TileCount count_;
};

}  // namespace noonmark
