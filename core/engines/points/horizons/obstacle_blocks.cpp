#include "core/engines/points/horizons/obstacle_blocks.h"

#include "core/engines/points/sky_trees.h"

namespace noonmark {

namespace {

constexpr float belowAll = -1e30F;

EdgeBlock blockOf(const BoxTree::Leaf& leaf, std::span<const TopEdge> edges) {
    EdgeBlock block{};
    block.az.fill(belowAll), block.bz.fill(belowAll);
    for (std::size_t i = 0; i < leaf.size(); ++i) {
        const TopEdge& edge = edges[leaf[i]];
        block.ax[i] = edge.a.x, block.ay[i] = edge.a.y, block.az[i] = edge.a.z;
        block.bx[i] = edge.b.x, block.by[i] = edge.b.y, block.bz[i] = edge.b.z;
        if (edge.oneSided) block.oneSided |= 1U << i;
    }
    return block;
}

FaceBlock blockOf(const BoxTree::Leaf& leaf, std::span<const OverhangFace> faces) {
    FaceBlock block{};
    for (auto& corner : block.z) corner.fill(belowAll);
    for (std::size_t i = 0; i < leaf.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const glm::vec3 place = faces[leaf[i]].corners[corner];
            block.x[corner][i] = place.x, block.y[corner][i] = place.y, block.z[corner][i] = place.z;
        }
    return block;
}

template <class Tree, class Obstacle>
Tree makeTree(std::span<const Obstacle> obstacles) {
    Tree tree{BoxTree(findBoxes(obstacles)), {}};
    for (const BoxTree::Leaf& leaf : tree.boxes.leaves()) tree.blocks.push_back(blockOf(leaf, obstacles));
    return tree;
}

}  // namespace

EdgeTree makeEdgeTree(std::span<const TopEdge> edges) { return makeTree<EdgeTree>(edges); }
FaceTree makeFaceTree(std::span<const OverhangFace> faces) { return makeTree<FaceTree>(faces); }

}  // namespace noonmark
