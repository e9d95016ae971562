#pragma once

#include <vector>

#include "core/city/city.h"
#include "core/city/meshes/mesh.h"

namespace noonmark {

/// Outlines of a building at the floors of its storeys, one closed ring each, as seen from outside: every
/// `storeyHeightM` (over 0) above `groundM` (local z) up to its top, without the ground floor's. At most 1000
/// floors. A mesh costs some ms for a hundred storeys.
std::vector<std::vector<glm::vec3>> makeStoreyLines(const Building& building, double groundM,
                                                    double storeyHeightM);

}  // namespace noonmark
