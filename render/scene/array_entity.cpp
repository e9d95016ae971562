#include "render/scene/array_entity.h"

#include <Qt3DRender/QLayer>

#include "render/scene/shader_material.h"

namespace noonmark {

ArrayGeometry* makeIndexedGeometry(Qt3DRender::QGeometryRenderer::PrimitiveType primitive,
                                   const std::vector<glm::vec3>& points,
                                   const std::vector<std::uint32_t>& indices) {
    auto* geometry = new ArrayGeometry(primitive);
    geometry->addPoints(QStringLiteral("vertexPosition"), points);
    geometry->setIndices(indices);
    return geometry;
}

ArrayGeometry* makeMeshGeometry(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> indices;
    for (const glm::uvec3 t : mesh.triangles) indices.insert(indices.end(), {t.x, t.y, t.z});
    return makeIndexedGeometry(Qt3DRender::QGeometryRenderer::Triangles, mesh.vertices, indices);
}

Qt3DCore::QEntity* makeArrayEntity(ArrayGeometry* geometry, ShaderMaterial& material,
                                   Qt3DCore::QEntity* parent, Qt3DRender::QLayer* layer) {
    auto* entity = new Qt3DCore::QEntity(parent);
    entity->addComponent(geometry);
    entity->addComponent(&material);
    if (layer) entity->addComponent(layer);
    return entity;
}

}  // namespace noonmark
