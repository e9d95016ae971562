#pragma once

#include <Qt3DCore/QEntity>

#include "render/array_geometry.h"

namespace noonmark {

class ShaderMaterial;

/// Triangles or lines between points, as the attribute "vertexPosition". Without a parent: who gets it owns
/// it.
ArrayGeometry* indexedGeometry(Qt3DRender::QGeometryRenderer::PrimitiveType primitive,
                               const std::vector<glm::vec3>& points,
                               const std::vector<std::uint32_t>& indices);

/// A geometry drawn with a material; `parent` owns it, and it the geometry. The material may be shared.
Qt3DCore::QEntity* arrayEntity(ArrayGeometry* geometry, ShaderMaterial& material, Qt3DCore::QEntity* parent);

}  // namespace noonmark
