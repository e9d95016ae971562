#pragma once

#include "core/city/building.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/common/shadow_reach.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// The receivers on which a building's shadow can fall at some step, by squares of 32 cells; the others lie
/// outside. Never leaves one out wrongly. O(cells + squares x degrees of azimuth visited).
Receivers findReached(const Building& building, const Receivers& receivers, const ShadowReach& reach);

/// Fills what a field of findReached() leaves open from the field with the building: there it makes no
/// difference. `receivers`: all.
void fillUnreached(ShadowField& without, const ShadowField& with, const Receivers& receivers);

}  // namespace noonmark
