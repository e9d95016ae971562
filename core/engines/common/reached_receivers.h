#pragma once

#include "core/engines/api/shadow_field.h"
#include "core/engines/common/changed_buildings.h"
#include "core/engines/common/shadow_reach.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// Keeps the receivers that the shadow of any of the buildings may reach at some step and marks the others as
/// outside. Works on tiles of 32 x 32 cells and never drops a receiver that shadow reaches. O(cells + tiles x
/// buildings x degrees of azimuth visited).
Receivers findReached(const Buildings& buildings, const Receivers& receivers, const ShadowReach& reach);

/// Fills the receivers that findReached() dropped with the values of the field with the building, which are
/// the same there. `receivers`: all receivers.
void fillUnreached(ShadowField& without, const ShadowField& with, const Receivers& receivers);

}  // namespace noonmark
