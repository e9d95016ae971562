#pragma once

#include <string>
#include <string_view>

#include "core/geo/grid.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

/// The smallest and the largest value that a number of a project file may have, both included.
struct NumberLimits {
    double low = 0;
    double high = 0;
};

/// Far beyond any project; nearer to the limits of float32 and int a sum or a product goes wrong.
inline constexpr NumberLimits placeLimitsM{-1e6, 1e6};      ///< local x or y
inline constexpr NumberLimits elevationLimitsM{-2e4, 2e4};  ///< local z, or above the ellipsoid
inline constexpr NumberLimits cellLimitsM{1e-3, 1e5};       ///< side of a grid's cell
inline constexpr NumberLimits sideLimits{1, 200000};        ///< columns or rows of a grid
inline constexpr std::size_t mostGridCells = 250'000'000;   ///< 1 GB of float32
inline constexpr NumberLimits layerLimits{-1e9, 1e9};       ///< values of a result

[[nodiscard]] bool isWithin(double value, const NumberLimits& limits);  ///< false for NaN

/// The numbers of a row of a project file, which may come from anybody: each is checked where it enters.
/// Throws DatabaseTrouble with table, row and column.
class CheckedRow {
public:
    /// Lives no longer than the statement's row. The row's id is in column `idColumn`.
    CheckedRow(const Statement& row, const char* table, int idColumn = 0)
        : row_(row), table_(table), id_(row.integer(idColumn)) {}

    [[nodiscard]] double number(int column, const char* name, const NumberLimits& limits) const;
    [[nodiscard]] int integer(int column, const char* name, const NumberLimits& limits) const;
    /// From five columns beginning with `column`: west_m, south_m, cell_m, columns, rows.
    [[nodiscard]] Grid grid(int column) const;
    [[noreturn]] void refuse(std::string_view what) const;

private:
    const Statement& row_;
    const char* table_;
    std::int64_t id_;
};

}  // namespace noonmark
