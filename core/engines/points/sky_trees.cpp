#include "core/engines/points/sky_trees.h"

namespace noonmark {

std::vector<ObstacleBox> findBoxes(std::span<const TopEdge> edges) {
    std::vector<ObstacleBox> boxes(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) boxes[i].add(edges[i].a), boxes[i].add(edges[i].b);
    return boxes;
}

std::vector<ObstacleBox> findBoxes(std::span<const OverhangFace> faces) {
    std::vector<ObstacleBox> boxes(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (const glm::vec3 corner : faces[i].corners) boxes[i].add(corner);
    return boxes;
}

}  // namespace noonmark
