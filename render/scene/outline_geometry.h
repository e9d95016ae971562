#pragma once

#include <vector>

#include "render/scene/array_geometry.h"

namespace noonmark {

/// A polyline on the ground.
struct GroundLine {
    std::vector<glm::vec3> points;
    bool closed = false;
};

/// The lines for the shader `ribbon`: four points per segment.
ArrayGeometry* makeOutlineGeometry(const std::vector<GroundLine>& lines);

}  // namespace noonmark
