#pragma once

#include <cstddef>
#include <stop_token>
#include <string>

#include "core/study/glazing/glazing_scene.h"

namespace noonmark {

/// How some windows of a review by horizons differ from rays: steps in sun by one and in shadow by the other,
/// percent of all steps.
struct GlazingSample {
    std::size_t windows = 0;
    double offPct = 0;
};

/// What horizons with ends by rays aim at: only glimpses of a minute or so are missed.
inline constexpr double glazingErrorTargetPct = 0.05;

/// Traces the middles of up to 64 windows, evenly chosen, in the scenario. A stop leaves windows out. Some
/// 0.1 us a window and step.
GlazingSample sampleGlazing(const GlazingScene& scene, const std::stop_token& stop);

/// "horizons of 64 windows are off by 1.203 % of the steps"
std::string describe(const GlazingSample& sample);

}  // namespace noonmark
