#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/api/step_sets.h"
#include "core/engines/horizon/attribution/attributed_tile.h"
#include "core/engines/horizon/attribution/building_gaps.h"
#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/overhangs/gaps.h"

namespace noonmark {

/// The steps of one bin in one set.
struct SetTable {
    std::size_t set;
    HiddenSuns hidden;
    std::vector<CountChange> suns;  ///< the same for many horizons at once
};
using SetTables = std::vector<SetTable>;

/// For each bin, the tables of the sets that have steps in it.
std::vector<SetTables> setTables(const BinnedSun& binned, const StepSets& sets);

/// Steps in shadow by set: one sum per number of a tile, and one per building.
class StepSums {
public:
    /// Begins another tile; the sums of buildings are kept. `buildings`: 0 if they are not needed.
    void begin(std::size_t sets, std::size_t numbers, std::size_t buildings);

    /// Adds the steps that the horizons of one bin hide, without buildings; flush() before cells(). `codes`:
    /// one per number.
    void add(const SetTables& tables, std::span<const HorizonCode> codes);
    /// Adds the steps that gaps hide above the horizons; `gaps`: sorted by number and altitude.
    void add(const SetTables& tables, std::span<const HorizonCode> codes, std::span<const Gap> gaps);

    /// The same with attribution to buildings.
    void add(const SetTables& tables, const AttributedTile& ranks);
    void add(const SetTables& tables, const AttributedTile& ranks, std::span<const BuildingGap> gaps);

    void flush();

    [[nodiscard]] std::size_t sets() const { return cells_.size(); }
    [[nodiscard]] bool begun() const { return !cells_.empty(); }
    [[nodiscard]] std::span<const std::uint32_t> cells(std::size_t set) const { return cells_[set]; }
    [[nodiscard]] std::uint64_t attributed(std::size_t building, std::size_t set) const {
        return attributed_[building * sets() + set];
    }
    [[nodiscard]] std::uint64_t sole(std::size_t building, std::size_t set) const {
        return sole_[building * sets() + set];
    }

private:
    /// Sums in 16 bits for as long as they cannot overflow: half of the memory that every bin goes through.
    struct ShortCells {
        std::vector<std::int16_t> sums;
        int most = 0;
    };

    void add(const SetTables& tables, std::uint32_t number, const AttributedView& view);
    void flush(std::size_t set);

    std::vector<std::vector<std::uint32_t>> cells_;
    std::vector<ShortCells> short_;                 // by set
    std::vector<std::uint64_t> attributed_, sole_;  // index: building x sets + set
};

}  // namespace noonmark
