#pragma once

#include <vector>

#include "render/scene/array_geometry.h"

namespace noonmark {

/// Points of a line on the ground, joined in order.
struct GroundLine {
    std::vector<glm::vec3> points;
    bool closed = false;
};

/// The lines for the shader `ribbon`: four points a piece.
ArrayGeometry* makeOutlineGeometry(const std::vector<GroundLine>& lines);

}  // namespace noonmark
