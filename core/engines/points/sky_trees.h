#pragma once

#include <span>
#include <vector>

#include "core/engines/points/obstacle_tree.h"
#include "core/engines/points/sky_obstacles.h"

namespace noonmark {

std::vector<ObstacleBox> findBoxes(std::span<const TopEdge> edges);
std::vector<ObstacleBox> findBoxes(std::span<const OverhangFace> faces);

/// Obstacles with trees over them, for the skylines of many points: the nearest obstacles hide most others,
/// which are then left out by the box. O(n log n) to make.
struct SkyTrees {
    SkyObstacles obstacles;
    ObstacleTree edges, faces;

    explicit SkyTrees(SkyObstacles all)
        : obstacles(std::move(all)), edges(findBoxes(obstacles.edges)), faces(findBoxes(obstacles.faces)) {}
};

}  // namespace noonmark
