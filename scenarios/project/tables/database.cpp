#include "scenarios/project/tables/database.h"

#include <fmt/format.h>
#include <cmath>

namespace noonmark {

bool isWithin(double value, const NumberLimits& limits) {
    return value >= limits.low && value <= limits.high;
}

void CheckedRow::refuse(std::string_view what) const {
    throwDamaged(fmt::format("table {}, row {}: {}", table_, id_, what));
}

double CheckedRow::number(int column, const char* name, const NumberLimits& limits) const {
    if (!row_.isNumber(column)) refuse(fmt::format("{} is not a number", name));
    const double value = row_.real(column);
    if (!isWithin(value, limits))
        refuse(fmt::format("{} is {:g}, not {:g} to {:g}", name, value, limits.low, limits.high));
    return value;
}

int CheckedRow::integer(int column, const char* name, const NumberLimits& limits) const {
    const double value = number(column, name, limits);
    if (value != std::floor(value)) refuse(fmt::format("{} is {:g}, not a whole number", name, value));
    return int(value);
}

Grid CheckedRow::grid(int column) const {
    const Grid grid{number(column, "west_m", placeLimitsM), number(column + 1, "south_m", placeLimitsM),
                    number(column + 2, "cell_m", cellLimitsM), integer(column + 3, "columns", sideLimits),
                    integer(column + 4, "rows", sideLimits)};
    if (grid.size() > maxGridCells)
        refuse(fmt::format("the grid has {} cells, more than {}", grid.size(), maxGridCells));
    if (!isWithin(grid.eastM(), placeLimitsM) || !isWithin(grid.northM(), placeLimitsM))
        refuse("the grid lies too far from the project's origin");
    return grid;
}

}  // namespace noonmark
