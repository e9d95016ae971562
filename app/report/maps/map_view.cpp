#include "app/report/maps/map_view.h"

#include <algorithm>
#include <glm/common.hpp>

namespace noonmark {

namespace {
constexpr double marginShare = 0.04;
constexpr double minSizeM = 1;  // an empty region still gets a view

glm::dvec2 sizeOf(const Box2& world) {
    return glm::max(glm::dvec2(world.high - world.low), glm::dvec2(minSizeM));
}
}  // namespace

MapView::MapView(const Box2& world, const QRectF& target)
    : target_(target), centre_((glm::dvec2(world.low) + glm::dvec2(world.high)) / 2.0) {
    const glm::dvec2 shown = sizeOf(world) * (1 + 2 * marginShare);
    unitsPerM_ = std::min(target.width() / shown.x, target.height() / shown.y);
}

QPointF MapView::at(glm::dvec2 local) const {
    const glm::dvec2 offset = (local - centre_) * unitsPerM_;
    return target_.center() + QPointF(offset.x, -offset.y);
}

QTransform MapView::transform() const {
    const QPointF origin = at({0, 0});
    return {unitsPerM_, 0, 0, -unitsPerM_, origin.x(), origin.y()};
}

QRectF MapView::rectOf(const Grid& grid) const {
    return {at({grid.westM, grid.northM()}), at({grid.eastM(), grid.southM})};
}

bool MapView::sees(const Box2& box) const {
    const QRectF shown = QRectF(at({box.low.x, box.high.y}), at({box.high.x, box.low.y}));
    return shown.left() <= target_.right() && shown.right() >= target_.left() &&
           shown.top() <= target_.bottom() && shown.bottom() >= target_.top();
}

void MapView::addTo(QPainterPath& path, const Footprint& footprint) const {
    const auto addRing = [&](const Ring& ring) {
        if (ring.empty()) return;
        path.moveTo(at(glm::dvec2(ring.front())));
        for (std::size_t i = 1; i < ring.size(); ++i) path.lineTo(at(glm::dvec2(ring[i])));
        path.closeSubpath();
    };
    addRing(footprint.outer);
    for (const Ring& hole : footprint.holes) addRing(hole);
}

double aspectOf(const Box2& world) {
    const glm::dvec2 size = sizeOf(world);
    return std::clamp(size.x / size.y, 0.5, 2.0);
}

}  // namespace noonmark
