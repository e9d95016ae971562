#pragma once

#include <string>
#include <string_view>

#include "core/geo/grid.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

/// Smallest and largest permitted value of a number in a project file, both inclusive.
struct NumberLimits {
    double low = 0;
    double high = 0;
};

/// Far beyond any project. Larger values could overflow sums and products in float32 and int.
inline constexpr NumberLimits placeLimitsM{-1e6, 1e6};      ///< local x and y
inline constexpr NumberLimits elevationLimitsM{-2e4, 2e4};  ///< local z, and heights above the ellipsoid
inline constexpr NumberLimits cellLimitsM{1e-3, 1e5};       ///< side of a grid's cell
inline constexpr NumberLimits sideLimits{1, 200000};        ///< columns and rows of a grid
inline constexpr std::size_t maxGridCells = 250'000'000;    ///< 1 GB of float32
inline constexpr NumberLimits layerLimits{-1e9, 1e9};       ///< values of a result

[[nodiscard]] bool isWithin(double value, const NumberLimits& limits);  ///< false for NaN

/// Reads the numbers of one row of a project file and checks each one, because project files are untrusted.
/// Throws DatabaseTrouble with table, row and column.
class CheckedRow {
public:
    /// Valid only while the statement stays on this row. `idColumn` holds the row's id.
    CheckedRow(const Statement& row, const char* table, int idColumn = 0)
        : row_(row), table_(table), id_(row.integer(idColumn)) {}

    [[nodiscard]] double number(int column, const char* name, const NumberLimits& limits) const;
    [[nodiscard]] int integer(int column, const char* name, const NumberLimits& limits) const;
    /// Reads five columns starting at `column`: west_m, south_m, cell_m, columns, rows.
    [[nodiscard]] Grid grid(int column) const;
    [[noreturn]] void refuse(std::string_view what) const;

private:
    const Statement& row_;
    const char* table_;
    std::int64_t id_;
};

}  // namespace noonmark
