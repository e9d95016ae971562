#pragma once

#include <QByteArray>
#include <Qt3DRender/QGeometryRenderer>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace Qt3DCore {
class QBuffer;
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

}  // namespace noonmark
