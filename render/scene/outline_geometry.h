#pragma once

#include <vector>

#include "core/city/meshes/mesh.h"
#include "render/scene/array_entity.h"

namespace noonmark {

/// A polyline on the ground.
struct GroundLine {
    std::vector<glm::vec3> points;
    bool closed = false;
};

/// The lines for the shader `ribbon`: four points per segment.
ArrayGeometry* makeOutlineGeometry(const std::vector<GroundLine>& lines);

/// A vertical double arrow from the origin up to `height`.
TriangleMesh makeDoubleArrow(float height);
/// A ball around the origin.
TriangleMesh makeBall(float diameter);
/// A pin with a round head that stands with its tip on the origin, `height` high.
TriangleMesh makePin(float height);

}  // namespace noonmark
