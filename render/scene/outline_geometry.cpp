#include "render/scene/outline_geometry.h"

namespace noonmark {

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

}  // namespace noonmark
