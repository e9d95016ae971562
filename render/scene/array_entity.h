#pragma once

#include <Qt3DCore/QEntity>

#include "render/scene/array_geometry.h"

namespace Qt3DRender {
class QLayer;
}

namespace noonmark {

class ShaderMaterial;

/// Triangles or lines between points, as the attribute "vertexPosition". Without a parent: who gets it owns
/// it.
ArrayGeometry* makeIndexedGeometry(Qt3DRender::QGeometryRenderer::PrimitiveType primitive,
                                   const std::vector<glm::vec3>& points,
                                   const std::vector<std::uint32_t>& indices);

/// A geometry drawn with a material; `parent` owns it, and it the geometry. Material and layer may be shared;
/// null: no layer of its own.
Qt3DCore::QEntity* makeArrayEntity(ArrayGeometry* geometry, ShaderMaterial& material,
                                   Qt3DCore::QEntity* parent, Qt3DRender::QLayer* layer = nullptr);

}  // namespace noonmark
