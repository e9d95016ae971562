#pragma once

#include <span>

#include "core/sun/sun_steps.h"

namespace noonmark {

/// The period made of these of its days only (indices of SunSteps::days, in the order given). What is missing
/// below the horizon is that of these days.
SunSteps chooseDays(const SunSteps& sun, std::span<const std::size_t> days);

}  // namespace noonmark
