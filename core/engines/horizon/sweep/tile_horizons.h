#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "core/base/huge_pages.h"
#include "core/engines/horizon/geometry/horizon_code.h"

namespace noonmark {

/// The horizon code for each bin and number of a tile: 2 bytes each, not initialised.
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
    struct Free {
        void operator()(HorizonCode* codes) const { freeHugePages(codes); }
    };
    std::unique_ptr<HorizonCode[], Free> codes_;
};

}  // namespace noonmark
