#include "core/engines/api/shadow_breakdown.h"

#include <algorithm>
#include <limits>

namespace noonmark {

std::vector<float> spreadOverGrid(const ShadowBreakdown& breakdown, std::size_t set) {
    std::vector<float> ofGrid(breakdown.grid.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < breakdown.cells.size(); ++i)
        ofGrid[breakdown.cells[i]] = breakdown.minutes[set][i];
    return ofGrid;
}

std::vector<float> valuesAt(const std::vector<std::uint32_t>& cells, const std::vector<float>& ofGrid) {
    std::vector<float> values;
    values.reserve(cells.size());
    for (const std::uint32_t cell : cells) values.push_back(ofGrid[cell]);
    return values;
}

std::size_t findReceiver(const ShadowBreakdown& breakdown, std::uint32_t cell) {
    return std::size_t(std::ranges::lower_bound(breakdown.cells, cell) - breakdown.cells.begin());
}

}  // namespace noonmark
