#pragma once

#include "core/engines/api/shadow_field.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Keys of Cost::skipped that every result has; the last only where there are such cells.
inline constexpr const char* cellsUnderBuildings = "cells under buildings";
inline constexpr const char* cellsOutside = "cells outside the region";
inline constexpr const char* cellsOnWater = "cells on water";

/// Square metres of the cells that were left out as water (WaterCells).
double findWaterM2(const Cost& cost, const Grid& grid);
inline double findWaterM2(const ShadowField& field) { return findWaterM2(field.cost, field.grid); }

/// Counts in Cost::skipped the cells that are no receivers, by what they are.
void countSkippedCells(Cost& cost, const Receivers& receivers);

/// The field that every engine starts from: the receivers' grid, 0 minutes at receivers and NaN elsewhere,
/// the period's day count, sunlit minutes and step length, and in Cost::skipped the cells and steps that no
/// engine has to process.
ShadowField makeBlankField(const Receivers& receivers, const SunSteps& sun);

/// Sets everything makeBlankField() sets except the minutes. For reusing a field of the same receivers for
/// another period.
void setPeriod(ShadowField& field, const Receivers& receivers, const SunSteps& sun);

}  // namespace noonmark
