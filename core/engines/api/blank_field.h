#pragma once

#include "core/engines/api/shadow_field.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Keys of Cost::skipped that every result has.
inline constexpr const char* cellsUnderBuildings = "cells under buildings";
inline constexpr const char* cellsOutside = "cells outside the region";

/// The field that every engine starts from: the receivers' grid, 0 minutes at receivers and NaN elsewhere,
/// the period's day count, sunlit minutes and step length, and in Cost::skipped the cells and steps that no
/// engine has to process.
ShadowField makeBlankField(const Receivers& receivers, const SunSteps& sun);

/// Sets everything makeBlankField() sets except the minutes. For reusing a field of the same receivers for
/// another period.
void setPeriod(ShadowField& field, const Receivers& receivers, const SunSteps& sun);

}  // namespace noonmark
