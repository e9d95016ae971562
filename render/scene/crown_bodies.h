#pragma once

#include <QColor>
#include <Qt3DCore/QEntity>
#include <memory>
#include <optional>
#include <vector>

#include "core/city/trees/tree.h"
#include "core/engines/ray/traced_view.h"
#include "render/view/camera_pose.h"

namespace Qt3DRender {
class QLayer;
}

namespace noonmark {

class ShaderMaterial;

/// A tree that a ray of the view meets first.
struct TreeHit {
    std::size_t tree = 0;  ///< its index
    double distanceM = 0;  ///< from the ray's origin to the crown
};
/// Crowns of all shapes are met as ellipsoids. O(trees), some 10 ns each.
std::optional<TreeHit> pickTree(const std::vector<Tree>& trees, const ViewRay& ray);

/// Trees as rays meet them, from the eye and towards the sun.
struct CrownRays {
    std::shared_ptr<const Trees> trees;  ///< of which they are; not null
    struct Scene {
        RayScene bodies;
        std::vector<LeafDays> seasons;  ///< of the scene's groups after those of evergreens and trunks
    };
    std::vector<Scene> scenes;  ///< any number, which are drawn as one
};
/// What is traced of them on this day of the year, 1 to 366.
std::vector<TracedTrees> listTraced(const CrownRays& rays, int dayOfYear);
/// Error if memory runs out; cancelled() soon after a stop request.
Result<std::shared_ptr<const CrownRays>> makeCrownRays(std::shared_ptr<const Trees> trees,
                                                       const std::stop_token& stop);

/// The crowns of trees as closed bodies.
struct CrownMeshes {
    TriangleMesh evergreen;
    /// Of trees that lose their leaves on equal days.
    struct Losing {
        LeafDays days;
        TriangleMesh crowns;
    };
    std::vector<Losing> losingLeaves;
};
CrownMeshes makeCrownMeshes(const Trees& trees);

/// What the parts of trees are drawn in.
struct CrownColours {
    QColor evergreen{0x4d, 0x6b, 0x4a};
    QColor leafy{0x7f, 0xa0, 0x62};
    QColor trunk{0x7a, 0x67, 0x55};
    QColor branches{0x6b, 0x5c, 0x50};
};

/// The trees of a city as simple bodies: a crown on a trunk. Without leaves a tree is a few branches, through
/// which one sees. Some 0.1 s for 100,000 trees, which are drawn with fewer faces each. Where rays draw the
/// trees, all that is left here are the branches of up to maxBranched trees.
class CrownBodies {
public:
    /// `parent` owns the nodes. `blended`: of branches. `side`: of all nodes.
    CrownBodies(Qt3DRender::QLayer* blended, Qt3DRender::QLayer* side, Qt3DCore::QEntity* parent,
                const CrownColours& colours = {});

    /// Replaces the trees; null: none.
    void show(std::shared_ptr<const Trees> trees);
    /// Which trees have leaves on this day of the year, 1 to 366.
    void setDay(int dayOfYear);
    void setVisible(bool visible);
    /// Whether rays draw crowns and trunks.
    void setTraced(bool traced);
    static constexpr std::size_t maxBranched = 2000;
    [[nodiscard]] bool isVisible() const { return visible_; }
    [[nodiscard]] int day() const { return dayOfYear_; }
    void setHaze(float distanceM);  ///< where what is far away fades into the background

private:
    void makeEntities();
    void enable();

    Qt3DRender::QLayer* blended_;
    Qt3DRender::QLayer* side_;
    Qt3DCore::QEntity* parent_;
    ShaderMaterial *evergreen_, *leafy_, *trunk_, *branch_;
    std::shared_ptr<const Trees> trees_;
    Qt3DCore::QEntity* root_ = nullptr;            ///< of all bodies; null until some are drawn
    std::vector<Qt3DCore::QEntity*> sameAllYear_;  ///< below root_: evergreens and trunks
    /// Below root_: trees that lose their leaves, of equal days, with and without them; null: none.
    struct Season {
        LeafDays days;
        Qt3DCore::QEntity* leaves = nullptr;
        Qt3DCore::QEntity* branches = nullptr;
    };
    std::vector<Season> seasons_;
    int dayOfYear_ = 172;
    bool visible_ = true, traced_ = false;
};

}  // namespace noonmark
