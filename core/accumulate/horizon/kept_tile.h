#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/bin_sweep.h"
#include "core/accumulate/horizon/kept_walls.h"
#include "core/accumulate/horizon/period_count.h"

namespace noonmark {

/// Horizons of a tile at one azimuth, exact for suns down to `lowest`.
struct KeptBin {
    HorizonCode lowest = 0;
    std::vector<HorizonCode> codes;  ///< one a number; none: not there
    [[nodiscard]] bool holds(const AzimuthBin& bin) const { return !codes.empty() && lowest <= bin.lowest(); }
};

/// The steps hidden in a tile in the period at hand, and what of it has to be counted anew.
struct TileCount {
    std::vector<std::uint32_t> hidden;  ///< one a number
    std::vector<std::uint8_t> changed;  ///< one for each 64 numbers: its longest runs are out of date
};

/// The horizons of a tile, kept while dates, hours and buildings change.
class KeptTile {
public:
    KeptTile(const Receivers& receivers, const TileBox& box, std::size_t bins);

    [[nodiscard]] const ReceiverBlocks& blocks() const { return blocks_; }
    [[nodiscard]] std::size_t bytes() const;
    void drop();

    /// Sweeps the bins that are not there or do not reach low enough, and counts. Returns how many it swept.
    std::size_t retime(const KeptWalls& walls, double cellM, const BinnedSun& binned,
                       const PeriodCount& count, const std::stop_token& stop);

    /// After the city changed: other receivers, prisms that went and came. Only horizons that may change are
    /// looked at. After a stop the tile is empty.
    void change(const Receivers& receivers, const KeptWalls& walls, const WallChange& change,
                const BinnedSun& binned, const PeriodCount* count, double binDeg,
                const std::stop_token& stop);

    /// Writes the minutes of what was counted anew since the last time, or of all.
    void write(const BinnedSun& binned, const PeriodCount& count, ShadowField& field, bool all,
               const std::stop_token& stop);

private:
    TileBox box_;
    ReceiverBlocks blocks_;
    std::vector<KeptBin> bins_;  // by number
    TileCount count_;
};

}  // namespace noonmark
