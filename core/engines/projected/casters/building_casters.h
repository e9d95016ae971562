#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/engines/projected/casters/shadow_casters.h"

namespace noonmark {

/// The casters of some buildings on flat ground, grouped by building.
class BuildingCasters {
public:
    BuildingCasters(std::vector<std::shared_ptr<const Building>> buildings, const Grid& grid);

    [[nodiscard]] const ShadowCasters& casters() const { return casters_; }
    [[nodiscard]] std::size_t buildings() const { return ends_.size(); }
    /// Indices of one building's casters.
    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t building) const {
        const std::size_t first = building == 0 ? 0 : ends_[building - 1];
        return std::span(order_).subspan(first, ends_[building] - first);
    }

private:
    ShadowCasters casters_;
    std::vector<std::uint32_t> order_;  // indices of casters, by building
    std::vector<std::size_t> ends_;     // end of each building in order_
};

}  // namespace noonmark
