#pragma once

#include <QByteArray>
#include <Qt3DRender/QGeometryRenderer>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace noonmark {

/// Names and arrays of one geometry; copied into buffers of Qt3D.
class ArrayGeometry final : public Qt3DRender::QGeometryRenderer {
    Q_OBJECT
public:
    explicit ArrayGeometry(Qt3DRender::QGeometryRenderer::PrimitiveType primitive,
                           Qt3DCore::QNode* parent = nullptr);

    void addPoints(const QString& attribute, const std::vector<glm::vec3>& values);
    void addNumbers(const QString& attribute, const std::vector<float>& values);
    void setIndices(const std::vector<std::uint32_t>& indices);

private:
    void add(const QString& attribute, const void* values, std::size_t count, unsigned numbersEach);
};

}  // namespace noonmark
