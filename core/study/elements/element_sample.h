#pragma once

#include "core/study/elements/element_study.h"

namespace noonmark {

/// Measures a sample of the study's points by rays and compares. Points are taken at equal distances in the
/// list, beginning at a place that the seed chooses; as many as the settings ask for and as maxRays allows.
/// `scene`: of the study's city; none: made here.
Result<ElementError> sampleElementError(const ElementStudy& study, const std::optional<RayScene>& scene,
                                        Progress& progress, const std::stop_token& stop);

/// Up to `count` indices of `all` points, ascending and evenly spread; the seed shifts them.
std::vector<std::size_t> choosePoints(std::size_t all, std::size_t count, std::uint32_t seed);
SurfacePoints pointsAt(const SurfacePoints& all, const std::vector<std::size_t>& chosen);

}  // namespace noonmark
