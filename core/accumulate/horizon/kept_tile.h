#pragma once

#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/bin_edit.h"
#include "core/accumulate/horizon/kept_walls.h"
#include "core/accumulate/horizon/period_count.h"

namespace noonmark {

/// Horizons of a tile at one azimuth, exact for suns down to `lowest`.
struct KeptBin {
    HorizonCode lowest = 0;
    std::vector<HorizonCode> codes;  ///< one a number; none: not there
    [[nodiscard]] bool holds(const AzimuthBin& bin) const { return !codes.empty() && lowest <= bin.lowest(); }
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
    std::size_t retime(const KeptWalls& walls, double cellM, const BinnedSun& binned,
                       const std::stop_token& stop);

    /// After the city changed: other receivers, prisms that went and came. Only horizons that may change are
    /// looked at. After a stop the tile is empty.
    void change(const Receivers& receivers, const KeptWalls& walls, const WallChange& change,
                const BinnedSun& binned, const PeriodCount& count, double binDeg,
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
    std::size_t sweep(const KeptWalls& walls, double cellM, const BinnedSun& binned,
                      const std::stop_token& stop);
    std::vector<BinTable> tablesFor(const BinnedSun& binned);
    void addHidden(const std::vector<BinTable>& tables, const std::stop_token& stop);
    [[nodiscard]] std::vector<Stretch> stretchesOfReceivers() const;
    void note(std::span<const CodeChange> changes, const HiddenSuns& hidden, std::span<std::uint32_t> more,
              std::span<std::uint8_t> parts) const;
    void take(std::span<const std::uint32_t> more, std::span<const std::uint8_t> parts);
    void allOld();

    TileBox box_;
    ReceiverBlocks blocks_;
    std::vector<KeptBin> bins_;  // by number
    TileCount count_;
};

}  // namespace noonmark
