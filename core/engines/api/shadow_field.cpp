#include "core/engines/api/shadow_field.h"

#include <algorithm>
#include <limits>

namespace noonmark {

double findWaterM2(const Cost& cost, const Grid& grid) {
    const auto found = cost.skipped.find(cellsOnWater);
    return found == cost.skipped.end() ? 0 : double(found->second) * grid.cellAreaM2();
}

void countSkippedCells(Cost& cost, const Receivers& receivers) {
    const auto cellsThatAre = [&](CellKind kind) {
        return std::uint64_t(std::count(receivers.kind.begin(), receivers.kind.end(), kind));
    };
    cost.skipped[cellsUnderBuildings] = cellsThatAre(CellKind::building);
    cost.skipped[cellsOutside] = cellsThatAre(CellKind::outside);
    const std::uint64_t water = cellsThatAre(CellKind::water);
    if (water > 0)
        cost.skipped[cellsOnWater] = water;
    else
        cost.skipped.erase(cellsOnWater);
}

ShadowField makeBlankField(const Receivers& receivers, const SunSteps& sun) {
    ShadowField field;
    field.grid = receivers.grid;
    field.grossMin.assign(receivers.grid.size(), std::numeric_limits<float>::quiet_NaN());
    for (const std::uint32_t cell : receivers.cells) field.grossMin[cell] = 0;
    field.continuousMin = field.grossMin;
    setPeriod(field, receivers, sun);
    return field;
}

void setPeriod(ShadowField& field, const Receivers& receivers, const SunSteps& sun) {
    field.stepMinutes = sun.stepMinutes;
    field.days = std::max(1, int(sun.dayCount()));
    field.sunlitMinutesPerDay = sun.sunlitMinutes() / field.days;
    field.cost = {};
    countSkippedCells(field.cost, receivers);
    field.cost.skipped["steps with the sun below the horizon"] = sun.belowHorizon;
}

}  // namespace noonmark
