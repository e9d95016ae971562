#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/ray/tree_rays.h"

namespace noonmark {

/// As traceTakenByTree(), of one place: minutes in place of min x m2, over the steps at which `shaded` is 0.
TakenByTree takeFromPoint(const CrownScene& crowns, glm::vec3 origin, const SunSteps& sun,
                          const std::vector<std::uint8_t>& shaded);

}  // namespace noonmark
