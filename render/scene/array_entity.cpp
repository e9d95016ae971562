#include "render/scene/array_entity.h"

#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QGeometry>
#include <Qt3DRender/QLayer>

#include "render/scene/shader_material.h"

namespace noonmark {

namespace {

Qt3DCore::QBuffer* bufferOf(const void* values, std::size_t bytes) {
    auto* buffer = new Qt3DCore::QBuffer;
    buffer->setData(QByteArray(static_cast<const char*>(values), qsizetype(bytes)));
    return buffer;
}

}  // namespace

ArrayGeometry::ArrayGeometry(Qt3DRender::QGeometryRenderer::PrimitiveType primitive, Qt3DCore::QNode* parent)
    : QGeometryRenderer(parent) {
    setGeometry(new Qt3DCore::QGeometry(this));
    setPrimitiveType(primitive);
}

void ArrayGeometry::add(const QString& attribute, const void* values, std::size_t count,
                        unsigned numbersEach) {
    auto* array = new Qt3DCore::QAttribute(bufferOf(values, count * numbersEach * sizeof(float)), attribute,
                                           Qt3DCore::QAttribute::Float, numbersEach, uint(count), 0,
                                           uint(numbersEach * sizeof(float)), geometry());
    array->setAttributeType(Qt3DCore::QAttribute::VertexAttribute);
    geometry()->addAttribute(array);
    if (attribute == Qt3DCore::QAttribute::defaultPositionAttributeName())
        geometry()->setBoundingVolumePositionAttribute(array);
}

void ArrayGeometry::addPoints(const QString& attribute, const std::vector<glm::vec3>& values) {
    add(attribute, values.data(), values.size(), 3);
}

void ArrayGeometry::addNumbers(const QString& attribute, const std::vector<float>& values) {
    add(attribute, values.data(), values.size(), 1);
}

void ArrayGeometry::setIndices(const std::vector<std::uint32_t>& indices) {
    auto* array = new Qt3DCore::QAttribute(geometry());
    array->setAttributeType(Qt3DCore::QAttribute::IndexAttribute);
    array->setVertexBaseType(Qt3DCore::QAttribute::UnsignedInt);
    indices_ = bufferOf(indices.data(), indices.size() * sizeof(std::uint32_t));
    array->setBuffer(indices_);
    array->setCount(uint(indices.size()));
    geometry()->addAttribute(array);
    setVertexCount(int(indices.size()));
}

void ArrayGeometry::changeIndices(std::size_t first, std::span<const std::uint32_t> indices) {
    if (indices.empty()) return;
    indices_->updateData(
        int(first * sizeof(std::uint32_t)),
        QByteArray(reinterpret_cast<const char*>(indices.data()), qsizetype(indices.size_bytes())));
}

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
