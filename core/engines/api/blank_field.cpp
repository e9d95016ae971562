#include "core/engines/api/blank_field.h"

#include <algorithm>
#include <limits>

namespace noonmark {

namespace {

void countSkipped(Cost& cost, const Receivers& receivers, const SunSteps& sun) {
    const auto cellsThatAre = [&](CellKind kind) {
        return std::uint64_t(std::count(receivers.kind.begin(), receivers.kind.end(), kind));
    };
    cost.skipped[cellsUnderBuildings] = cellsThatAre(CellKind::building);
    cost.skipped[cellsOutside] = cellsThatAre(CellKind::outside);
    cost.skipped["steps with the sun below the horizon"] = sun.belowHorizon;
}

}  // namespace

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
    countSkipped(field.cost, receivers, sun);
}

}  // namespace noonmark
