#pragma once

#include <memory>
#include <vector>

#include "core/accumulate/horizon/horizon_code.h"
#include "core/accumulate/horizon/longest_runs.h"
#include "core/accumulate/horizon/receiver_blocks.h"

namespace noonmark {

/// For each bin and number of a tile the code of its horizon: 2 bytes each, not cleared.
class TileHorizons {
public:
    TileHorizons(std::size_t bins, std::size_t numbers);

    [[nodiscard]] std::size_t numbers() const { return numbers_; }
    [[nodiscard]] std::span<HorizonCode> of(std::size_t bin) {
        return {codes_.get() + bin * numbers_, numbers_};
    }
    [[nodiscard]] std::span<const HorizonCode> of(std::size_t bin) const {
        return {codes_.get() + bin * numbers_, numbers_};
    }

private:
    std::size_t numbers_;
    std::unique_ptr<HorizonCode[]> codes_;
};

/// The numbers [first, first + 64) of each of some bins' codes; beyond the last number noHorizon.
void copyLanes(std::span<const std::span<const HorizonCode>> bins, std::size_t first,
               std::vector<RunLanes>& lanes);

}  // namespace noonmark
