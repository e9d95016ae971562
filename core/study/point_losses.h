#pragma once

#include <vector>

#include "core/study/point_study.h"

namespace noonmark {

/// The seasons in which steps that were lit are in shadow, most minutes first. The days are those of one
/// year, whose end joins its beginning.
std::vector<SeasonOfLoss> findLosses(const ShadedSteps& before, const ShadedSteps& after, const SunSteps& sun,
                                     const Zone& zone);

}  // namespace noonmark
