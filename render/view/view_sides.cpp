#include "render/view/view_sides.h"

#include <algorithm>
#include <cmath>

#include "render/scene/array_entity.h"
#include "render/scene/shader_material.h"

namespace noonmark {

SideColumns columnsOf(const ViewSides& sides, int side, int widthPx) {
    if (sides.layout == SideLayout::one) return side == 0 ? SideColumns{0, widthPx} : SideColumns{};
    const double share = sides.layout == SideLayout::beside ? 0.5 : std::clamp(sides.divider, 0.0, 1.0);
    const int divider = int(std::lround(share * widthPx));
    return side == 0 ? SideColumns{divider, widthPx} : SideColumns{0, divider};
}

namespace {

constexpr float halfWidthPx = 2;

}  // namespace

SideDivider::SideDivider(Qt3DRender::QLayer* blended, const std::array<Qt3DRender::QLayer*, 2>& sides,
                         Qt3DCore::QEntity* parent)
    : blended_(blended),
      sideLayers_(sides),
      parent_(parent),
      material_(new ShaderMaterial(QStringLiteral("traced"), QStringLiteral("divider"), parent)) {
    material_->blend();
    material_->alwaysVisible();
    material_->bothSides();
}

// A band over the height of the picture, in clip space.
void SideDivider::add(float x, float halfWidth, Qt3DRender::QLayer* side) {
    const std::vector<glm::vec3> corners{
        {x - halfWidth, -1, 0}, {x + halfWidth, -1, 0}, {x + halfWidth, 1, 0}, {x - halfWidth, 1, 0}};
    bands_.push_back(makeArrayEntity(
        makeIndexedGeometry(Qt3DRender::QGeometryRenderer::Triangles, corners, {0, 1, 2, 0, 2, 3}),
        *material_, parent_, blended_));
    if (side) bands_.back()->addComponent(side);
}

void SideDivider::show(const ViewSides& sides, int widthPx) {
    for (Qt3DCore::QEntity* band : bands_) delete band;
    bands_.clear();
    if (sides.layout == SideLayout::beside) {
        const float halfWidth = 2 * halfWidthPx / float(std::max(1, widthPx / 2));
        add(-1, halfWidth, sideLayers_[0]);
        add(1, halfWidth, sideLayers_[1]);
    }
    if (sides.layout == SideLayout::swipe && sides.divider > 0 && sides.divider < 1)
        add(float(2 * sides.divider - 1), 2 * halfWidthPx / float(std::max(1, widthPx)), nullptr);
}

}  // namespace noonmark
