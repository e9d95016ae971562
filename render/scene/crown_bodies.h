#pragma once

#include <Qt3DCore/QEntity>
#include <memory>

#include "core/city/trees/tree.h"

namespace Qt3DRender {
class QLayer;
}

namespace noonmark {

class ShaderMaterial;

/// The trees of a city as simple bodies: a crown on a trunk. Without leaves a tree is a few branches, through
/// which one sees. Some 0.1 s for 100,000 trees, which are drawn with fewer faces each.
class CrownBodies {
public:
    /// `parent` owns the nodes. `blended`: of branches. `side`: of all nodes.
    CrownBodies(Qt3DRender::QLayer* blended, Qt3DRender::QLayer* side, Qt3DCore::QEntity* parent);

    /// Replaces the trees; null: none.
    void show(std::shared_ptr<const Trees> trees);
    /// Which trees have leaves on this day of the year, 1 to 366.
    void setDay(int dayOfYear);
    void setVisible(bool visible);
    void setHaze(float distanceM);  ///< where what is far away fades into the background
    [[nodiscard]] const std::shared_ptr<const Trees>& trees() const { return trees_; }

private:
    void enable();

    Qt3DRender::QLayer* blended_;
    Qt3DRender::QLayer* side_;
    Qt3DCore::QEntity* parent_;
    ShaderMaterial *evergreen_, *leafy_, *trunk_, *branch_;
    std::shared_ptr<const Trees> trees_;
    Qt3DCore::QEntity* root_ = nullptr;      ///< of all bodies
    Qt3DCore::QEntity* leaves_ = nullptr;    ///< below root_: of trees that lose them
    Qt3DCore::QEntity* branches_ = nullptr;  ///< likewise, of the same trees without leaves
    int dayOfYear_ = 172;
    bool visible_ = true;
};

}  // namespace noonmark
