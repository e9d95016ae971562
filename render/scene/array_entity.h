#pragma once

#include <QByteArray>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QGeometryRenderer>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/city/meshes/mesh.h"

namespace Qt3DCore {
class QBuffer;
}
namespace Qt3DRender {
class QLayer;
}

namespace noonmark {

/// The arrays of one geometry by attribute name, copied into Qt3D buffers.
class ArrayGeometry final : public Qt3DRender::QGeometryRenderer {
    Q_OBJECT
public:
    explicit ArrayGeometry(Qt3DRender::QGeometryRenderer::PrimitiveType primitive,
                           Qt3DCore::QNode* parent = nullptr);

    void addPoints(const QString& attribute, const std::vector<glm::vec3>& values);
    void addNumbers(const QString& attribute, const std::vector<float>& values);
    void setIndices(const std::vector<std::uint32_t>& indices);
    /// Replaces indices from position `first` on; the number of indices stays. Uploads only these.
    void changeIndices(std::size_t first, std::span<const std::uint32_t> indices);

private:
    void add(const QString& attribute, const void* values, std::size_t count, unsigned numbersEach);

    Qt3DCore::QBuffer* indices_ = nullptr;
};

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
