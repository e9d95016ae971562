#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/measures/shadow_outlines.h"

namespace noonmark {

/// As outlineShadows(), for any ground: cells that are ground in both cities are traced by the ray reference,
/// and the outlines run along their edges. Cost: that of the ray reference, and O(cells).
Result<std::vector<ShadowOutlines>> traceOutlines(const City& baseline, const City* scenario,
                                                  std::span<const SunStep> steps,
                                                  const OutlineSettings& settings, Progress& progress,
                                                  const std::stop_token& stop);

}  // namespace noonmark
