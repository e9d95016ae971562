#pragma once

#include <Qt3DCore/QEntity>

#include "core/city/meshes/mesh.h"
#include "render/scene/array_geometry.h"

namespace Qt3DRender {
class QLayer;
}

namespace noonmark {

class ShaderMaterial;

/// Triangles or lines between points, as the attribute "vertexPosition". It has no parent; the caller passes
/// it on to an owner.
ArrayGeometry* makeIndexedGeometry(Qt3DRender::QGeometryRenderer::PrimitiveType primitive,
                                   const std::vector<glm::vec3>& points,
                                   const std::vector<std::uint32_t>& indices);

/// The triangles of a mesh, in the same way.
ArrayGeometry* makeMeshGeometry(const TriangleMesh& mesh);

/// An entity that draws a geometry with a material. `parent` owns it, and it owns the geometry. Material and
/// layer may be shared; null: no layer.
Qt3DCore::QEntity* makeArrayEntity(ArrayGeometry* geometry, ShaderMaterial& material,
                                   Qt3DCore::QEntity* parent, Qt3DRender::QLayer* layer = nullptr);

}  // namespace noonmark
