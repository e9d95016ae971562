#pragma once

#include "core/engines/api/shadow_field.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Keys of Cost.skipped that every result has.
inline constexpr const char* cellsUnderBuildings = "cells under buildings";
inline constexpr const char* cellsOutside = "cells outside the region";

/// What every engine starts from: the receivers' grid, 0 minutes at receivers and NaN elsewhere, the period's
/// figures, and in Cost.skipped the cells and steps that no engine has to touch.
ShadowField blankField(const Receivers& receivers, const SunSteps& sun);

/// All of that but the minutes, for a field of these receivers that is to hold another period.
void setPeriod(ShadowField& field, const Receivers& receivers, const SunSteps& sun);

}  // namespace noonmark
