#include "render/scene/crown_bodies.h"

#include <Qt3DRender/QLayer>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "render/scene/array_entity.h"
#include "render/scene/qt_vectors.h"
#include "render/scene/shader_material.h"
#include "render/view/frame_graph.h"

namespace noonmark {

namespace {

constexpr std::size_t maxDetailed = 20'000;  // trees; more are drawn with fewer faces
constexpr int trunkSides = 3;
constexpr float trunkShare = 0.02F;  // radius of the trunk as a share of the tree's height

struct Detail {
    int sides = 8;
    bool isRound = true;  ///< ellipsoids have three rings; else one
    bool hasTrunk = true;
};

// Points (share of the radius, share of the height) from the bottom of a crown to its top.
std::vector<glm::vec2> profileOf(CrownShape shape, const Detail& detail) {
    if (shape == CrownShape::cone) return {{0, 0}, {1, 0}, {0, 1}};
    if (shape == CrownShape::cylinder) return {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    if (!detail.isRound) return {{0, 0}, {1, 0.5F}, {0, 1}};
    return {{0, 0}, {0.8F, 0.2F}, {1, 0.5F}, {0.8F, 0.8F}, {0, 1}};
}

// A ring of points, or one on the axis.
std::uint32_t addRing(TriangleMesh& mesh, glm::vec3 middle, float radius, int sides) {
    const auto first = std::uint32_t(mesh.vertices.size());
    if (radius == 0) {
        mesh.vertices.push_back(middle);
        return first;
    }
    for (int side = 0; side < sides; ++side) {
        const float angle = 2 * std::numbers::pi_v<float> * float(side) / float(sides);
        mesh.vertices.push_back(middle + radius * glm::vec3(std::cos(angle), std::sin(angle), 0));
    }
    return first;
}

// Between two rings of which one may be a point.
void joinRings(TriangleMesh& mesh, std::uint32_t low, bool lowIsPoint, std::uint32_t high, bool highIsPoint,
               int sides) {
    const auto all = std::uint32_t(sides);
    for (std::uint32_t side = 0; side < all; ++side) {
        const std::uint32_t next = (side + 1) % all;
        if (!lowIsPoint) mesh.triangles.push_back({low + side, low + next, highIsPoint ? high : high + next});
        if (!highIsPoint) mesh.triangles.push_back({lowIsPoint ? low : low + side, high + next, high + side});
    }
}

void addCrown(TriangleMesh& mesh, const Crown& crown, const Detail& detail) {
    const glm::vec3 foot(crown.x, crown.y, crown.bottomM);
    std::uint32_t low = 0;
    bool lowIsPoint = true, begun = false;
    for (const glm::vec2 point : profileOf(crown.shape, detail)) {
        const auto height = float(point.y * (crown.topM - crown.bottomM));
        const std::uint32_t high =
            addRing(mesh, foot + glm::vec3(0, 0, height), point.x * float(crown.radiusM), detail.sides);
        if (begun) joinRings(mesh, low, lowIsPoint, high, point.x == 0, detail.sides);
        low = high;
        lowIsPoint = point.x == 0;
        begun = true;
    }
}

void addTrunk(TriangleMesh& mesh, const Tree& tree, const Crown& crown) {
    const glm::vec3 foot(crown.x, crown.y, tree.groundM);
    const glm::vec3 top(crown.x, crown.y, (crown.bottomM + crown.topM) / 2);
    const std::uint32_t low = addRing(mesh, foot, trunkShare * tree.heightM, trunkSides);
    joinRings(mesh, low, false, addRing(mesh, top, 0, trunkSides), true, trunkSides);
}

/// The ends of lines.
struct Lines {
    std::vector<glm::vec3> points;
    std::vector<std::uint32_t> ends;
};

// From the axis to the widest ring and to the top.
void addBranches(Lines& lines, const Tree& tree, const Crown& crown, int sides) {
    const auto axis = std::uint32_t(lines.points.size());
    const auto at = [&](double z) { return glm::vec3(crown.x, crown.y, z); };
    const double middle = (crown.bottomM + crown.topM) / 2;
    lines.points.insert(lines.points.end(), {at(tree.groundM), at(crown.bottomM), at(crown.topM)});
    for (const std::uint32_t end : {0U, 1U, 1U, 2U}) lines.ends.push_back(axis + end);
    for (int side = 0; side < sides; ++side) {
        const double angle = 2 * std::numbers::pi * side / sides;
        const double z = side % 2 == 0 ? middle : (middle + crown.topM) / 2;
        const double radius = crown.radiusM * (side % 2 == 0 ? 1 : 0.7);
        lines.ends.insert(lines.ends.end(), {axis + 1, std::uint32_t(lines.points.size())});
        lines.points.push_back(at(z) + glm::vec3(radius * std::cos(angle), radius * std::sin(angle), 0));
    }
}

/// What is drawn of some trees.
struct Bodies {
    TriangleMesh evergreen, trunks;
    /// Of trees that lose their leaves on equal days.
    struct Season {
        LeafDays days;
        TriangleMesh leafy;
        Lines branches;
    };
    std::vector<Season> seasons;
};

Bodies makeBodies(const Trees& trees) {
    const Detail detail = trees.trees.size() <= maxDetailed ? Detail{} : Detail{4, false, false};
    Bodies bodies;
    LeafSeasons seasons(trees.leafDays);
    for (const Tree& tree : trees.trees) {
        const Crown crown = makeCrown(tree);
        const std::size_t season = seasons.add(tree);
        bodies.seasons.resize(seasons.days().size());
        bodies.seasons[season].days = seasons.days()[season];
        addCrown(tree.evergreen ? bodies.evergreen : bodies.seasons[season].leafy, crown, detail);
        if (detail.hasTrunk) addTrunk(bodies.trunks, tree, crown);
        if (!tree.evergreen) addBranches(bodies.seasons[season].branches, tree, crown, detail.sides);
    }
    return bodies;
}

Qt3DCore::QEntity* drawMesh(const TriangleMesh& mesh, ShaderMaterial& material, Qt3DCore::QEntity* parent,
                            Qt3DRender::QLayer* side) {
    return mesh.triangles.empty() ? nullptr : makeArrayEntity(makeMeshGeometry(mesh), material, parent, side);
}

}  // namespace

std::optional<TreeHit> pickTree(const std::vector<Tree>& trees, const ViewRay& ray) {
    std::optional<TreeHit> first;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const Crown crown = makeCrown(trees[i]);
        const double halfM = (crown.topM - crown.bottomM) / 2;
        const glm::dvec3 radii(crown.radiusM, crown.radiusM, halfM);
        // In the space in which the crown is a unit ball around the origin.
        const glm::dvec3 from = (ray.origin - glm::dvec3(crown.x, crown.y, crown.bottomM + halfM)) / radii;
        const glm::dvec3 along = ray.direction / radii;
        const double a = glm::dot(along, along), b = glm::dot(from, along);
        const double root = b * b - a * (glm::dot(from, from) - 1);
        if (root < 0) continue;
        const double distanceM = (-b - std::sqrt(root)) / a;
        if (distanceM > 0 && (!first || distanceM < first->distanceM)) first = TreeHit{i, distanceM};
    }
    return first;
}

namespace {

// The first groups of a scene of trees; those of trees that lose their leaves follow, by season.
constexpr std::uint32_t evergreenGroup = 0, trunkGroup = 1, firstSeason = 2;

Crown trunkOf(const Tree& tree, const Crown& crown) {
    Crown trunk = crown;
    trunk.shape = CrownShape::cylinder;
    trunk.radiusM = double(trunkShare * tree.heightM) / 2;
    trunk.bottomM = tree.groundM;
    trunk.topM = (crown.bottomM + crown.topM) / 2;
    return trunk;
}

}  // namespace

Result<std::shared_ptr<const CrownRays>> makeCrownRays(std::shared_ptr<const Trees> trees,
                                                       const std::stop_token& stop) {
    LeafSeasons seasons(trees->leafDays);
    std::vector<GroupedCrown> bodies;
    for (const Tree& tree : trees->trees) {
        const Crown crown = makeCrown(tree);
        bodies.push_back({crown, tree.evergreen ? evergreenGroup : firstSeason + seasons.add(tree)});
        bodies.push_back({trunkOf(tree, crown), trunkGroup});
    }
    auto scene = RayScene::over(std::move(bodies), stop);
    if (!scene) return tl::make_unexpected(scene.error());
    return std::make_shared<const CrownRays>(
        CrownRays{std::move(trees), {{*std::move(scene), seasons.days()}}});
}

CrownMeshes makeCrownMeshes(const Trees& trees) {
    Bodies bodies = makeBodies(trees);
    CrownMeshes meshes{std::move(bodies.evergreen), {}};
    for (Bodies::Season& season : bodies.seasons)
        meshes.losingLeaves.push_back({season.days, std::move(season.leafy)});
    return meshes;
}

std::vector<TracedTrees> listTraced(const CrownRays& rays, int dayOfYear) {
    std::vector<TracedTrees> traced;
    for (const CrownRays::Scene& scene : rays.scenes) {
        std::vector<TreePart> parts{TreePart::evergreen, TreePart::trunk};
        for (const LeafDays& days : scene.seasons)
            parts.push_back(days.inLeafOn(dayOfYear) ? TreePart::leafy : TreePart::bare);
        traced.push_back({scene.bodies, std::move(parts)});
    }
    return traced;
}

CrownBodies::CrownBodies(Qt3DRender::QLayer* blended, Qt3DRender::QLayer* side, Qt3DCore::QEntity* parent,
                         const CrownColours& colours)
    : blended_(blended), side_(side), parent_(parent) {
    const auto tinted = [&](const QColor& colour) {
        auto* material = new ShaderMaterial(QStringLiteral("crown"), parent);
        material->set(QStringLiteral("baseColour"), toVector(colour));
        material->set(QStringLiteral("haze"), toVector(backgroundColour));
        material->drawDepthFirst();
        return material;
    };
    evergreen_ = tinted(colours.evergreen);
    leafy_ = tinted(colours.leafy);
    trunk_ = tinted(colours.trunk);
    branch_ = new ShaderMaterial(QStringLiteral("edge"), parent);
    branch_->set(QStringLiteral("edgeColour"), toVector(colours.branches));
    branch_->blend();
}

void CrownBodies::show(std::shared_ptr<const Trees> trees) {
    if (trees == trees_) return;
    trees_ = std::move(trees);
    delete root_;
    root_ = nullptr;
    sameAllYear_.clear();
    seasons_.clear();
    enable();
}

void CrownBodies::makeEntities() {
    root_ = new Qt3DCore::QEntity(parent_);
    const Bodies bodies = makeBodies(*trees_);
    for (Qt3DCore::QEntity* entity : {drawMesh(bodies.evergreen, *evergreen_, root_, side_),
                                      drawMesh(bodies.trunks, *trunk_, root_, side_)})
        if (entity) sameAllYear_.push_back(entity);
    for (const Bodies::Season& season : bodies.seasons) {
        seasons_.push_back({season.days, drawMesh(season.leafy, *leafy_, root_, side_)});
        if (season.branches.ends.empty()) continue;
        Qt3DCore::QEntity*& branches = seasons_.back().branches;
        branches = makeArrayEntity(makeIndexedGeometry(Qt3DRender::QGeometryRenderer::Lines,
                                                       season.branches.points, season.branches.ends),
                                   *branch_, root_, blended_);
        branches->addComponent(side_);
    }
}

void CrownBodies::setDay(int dayOfYear) {
    dayOfYear_ = dayOfYear;
    enable();
}

void CrownBodies::setVisible(bool visible) {
    visible_ = visible;
    enable();
}

void CrownBodies::setTraced(bool traced) {
    traced_ = traced;
    enable();
}

void CrownBodies::setHaze(float distanceM) {
    for (ShaderMaterial* material : {evergreen_, leafy_, trunk_, branch_})
        material->set(QStringLiteral("hazeDistance"), distanceM);
}

void CrownBodies::enable() {
    const std::size_t count = trees_ ? trees_->trees.size() : 0;
    const bool drawn = visible_ && count > 0 && (!traced_ || count <= maxBranched);
    if (drawn && !root_) makeEntities();
    if (!root_) return;
    root_->setEnabled(drawn);
    for (Qt3DCore::QEntity* entity : sameAllYear_) entity->setEnabled(!traced_);
    for (const Season& season : seasons_) {
        const bool inLeaf = season.days.inLeafOn(dayOfYear_);
        if (season.leaves) season.leaves->setEnabled(inLeaf && !traced_);
        if (season.branches) season.branches->setEnabled(!inLeaf);
    }
}

}  // namespace noonmark
