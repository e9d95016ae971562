#pragma once

#include <span>

#include "core/sun/sun_steps.h"

namespace noonmark {

/// A period that consists of some days of `sun` (indices of SunSteps::days, in the order given). Steps below
/// the horizon are counted for these days only.
SunSteps chooseDays(const SunSteps& sun, std::span<const std::size_t> days);

}  // namespace noonmark
