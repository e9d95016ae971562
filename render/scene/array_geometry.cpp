#include "render/scene/array_geometry.h"

#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QGeometry>

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

}  // namespace noonmark
