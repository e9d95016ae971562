#pragma once

#include <Qt3DCore/QEntity>
#include <array>
#include <vector>

#include "render/view/view_sides.h"

namespace Qt3DRender {
class QLayer;
}

namespace noonmark {

class ShaderMaterial;

/// The line between two sides of the view.
class SideDivider {
public:
    /// `parent` owns the nodes. `sides`: the layers of what only one side shows.
    SideDivider(Qt3DRender::QLayer* blended, const std::array<Qt3DRender::QLayer*, 2>& sides,
                Qt3DCore::QEntity* parent);

    /// `widthPx` of the view, in device-independent pixels.
    void show(const ViewSides& sides, int widthPx);

private:
    void add(float x, float halfWidth, Qt3DRender::QLayer* side);

    Qt3DRender::QLayer* blended_;
    std::array<Qt3DRender::QLayer*, 2> sideLayers_;
    Qt3DCore::QEntity* parent_;
    ShaderMaterial* material_;
    std::vector<Qt3DCore::QEntity*> bands_;
};

}  // namespace noonmark
