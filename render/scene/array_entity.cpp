#include "render/scene/array_entity.h"

#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QGeometry>
#include <Qt3DRender/QLayer>
#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>

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

namespace {

struct Ribbon {
    std::vector<glm::vec3> points;
    std::vector<glm::vec3> others;
    std::vector<float> sides;
    std::vector<std::uint32_t> triangles;
};

// Seen from the other end left and right swap, and so do the signs.
void addPiece(Ribbon& ribbon, glm::vec3 a, glm::vec3 b) {
    const auto first = std::uint32_t(ribbon.points.size());
    ribbon.points.insert(ribbon.points.end(), {a, a, b, b});
    ribbon.others.insert(ribbon.others.end(), {b, b, a, a});
    ribbon.sides.insert(ribbon.sides.end(), {1, -1, -1, 1});
    for (const std::uint32_t corner : {0U, 1U, 3U, 0U, 3U, 2U}) ribbon.triangles.push_back(first + corner);
}

void addLine(Ribbon& ribbon, const GroundLine& line) {
    for (std::size_t i = 1; i < line.points.size(); ++i) addPiece(ribbon, line.points[i - 1], line.points[i]);
    if (line.closed && line.points.size() > 2) addPiece(ribbon, line.points.back(), line.points.front());
}

}  // namespace

ArrayGeometry* makeOutlineGeometry(const std::vector<GroundLine>& lines) {
    Ribbon ribbon;
    for (const GroundLine& line : lines) addLine(ribbon, line);
    auto* geometry = new ArrayGeometry(Qt3DRender::QGeometryRenderer::Triangles);
    geometry->addPoints(QStringLiteral("vertexPosition"), ribbon.points);
    geometry->addPoints(QStringLiteral("otherEnd"), ribbon.others);
    geometry->addNumbers(QStringLiteral("side"), ribbon.sides);
    geometry->setIndices(ribbon.triangles);
    return geometry;
}

namespace {

constexpr int sides = 24;

// A surface of revolution about the z axis, through points (radius, z) from bottom to top.
void addTurned(TriangleMesh& mesh, const std::vector<glm::vec2>& profile) {
    const auto first = std::uint32_t(mesh.vertices.size());
    const auto ring = std::uint32_t(sides);
    for (const glm::vec2 point : profile)
        for (int side = 0; side < sides; ++side) {
            const float angle = 2 * std::numbers::pi_v<float> * float(side) / float(sides);
            mesh.vertices.emplace_back(point.x * std::cos(angle), point.x * std::sin(angle), point.y);
        }
    for (std::uint32_t row = 0; row + 1 < profile.size(); ++row)
        for (std::uint32_t side = 0; side < ring; ++side) {
            const std::uint32_t a = first + row * ring + side;
            const std::uint32_t b = first + row * ring + (side + 1) % ring;
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, b + ring}, {a, b + ring, a + ring}});
        }
}

}  // namespace

TriangleMesh makeDoubleArrow(float height) {
    const float neck = height * 0.34F;  // length of an arrowhead
    const float wide = height * 0.17F, thin = height * 0.06F;
    TriangleMesh mesh;
    addTurned(
        mesh,
        {{0, 0}, {wide, neck}, {thin, neck}, {thin, height - neck}, {wide, height - neck}, {0, height}});
    return mesh;
}

TriangleMesh makeBall(float diameter) {
    constexpr int rings = 12;
    std::vector<glm::vec2> profile;
    for (int i = 0; i <= rings; ++i) {
        const float angle = std::numbers::pi_v<float> * (float(i) / rings - 0.5F);
        profile.emplace_back(diameter / 2 * std::cos(angle), diameter / 2 * std::sin(angle));
    }
    TriangleMesh mesh;
    addTurned(mesh, profile);
    return mesh;
}

TriangleMesh makePin(float height) {
    const float radius = height * 0.2F, middle = height - radius;
    std::vector<glm::vec2> profile{{0, 0}};
    constexpr int rings = 12;
    // The head begins where the cone touches it.
    const float touch = -std::asin(radius / middle);
    for (int i = 0; i <= rings; ++i) {
        const float angle = touch + (std::numbers::pi_v<float> / 2 - touch) * float(i) / rings;
        profile.emplace_back(radius * std::cos(angle), middle + radius * std::sin(angle));
    }
    TriangleMesh mesh;
    addTurned(mesh, profile);
    return mesh;
}

}  // namespace noonmark
