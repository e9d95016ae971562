#include "app/gui/tools/editing/box_selection.h"

#include <QRubberBand>
#include <QWindow>
#include <glm/vector_relational.hpp>

#include "core/city/terrain/building_ground.h"
#include "scenarios/edits/placed_building.h"

namespace noonmark {

namespace {

constexpr int framePx = 2;

glm::dvec3 findCentre(const Building& building, const City& city) {
    const double ground = double(findGroundUnder(building, city));
    return {findMiddle(building), (ground + double(topM(building))) / 2};
}

bool isInside(const SectionBox& box, const glm::dvec3& point) {
    return glm::all(glm::lessThanEqual(box.lowM, point)) && glm::all(glm::lessThanEqual(point, box.highM));
}

}  // namespace

std::vector<std::uint32_t> findBuildingsIn(const QRectF& pixels, const City& city, const CameraPose& pose,
                                           const ViewLens& lens, const std::optional<SectionBox>& section) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < city.buildings.size(); ++i) {
        const glm::dvec3 centre = findCentre(*city.buildings[i], city);
        const auto pixel = pixelOf(pose, lens, centre);
        if (!pixel || !pixels.contains(pixel->x, pixel->y)) continue;
        if (!section || isInside(*section, centre)) found.push_back(i);
    }
    return found;
}

BoxSelection::BoxSelection(const QWindow& view) : view_(view) {}

BoxSelection::~BoxSelection() = default;

// A window of its own, because no widget can be drawn over the view's native window. It is cut down to its
// frame: a translucent one would be opaque where no compositor runs.
void BoxSelection::show(const QRectF& pixels) {
    if (!band_) band_ = std::make_unique<QRubberBand>(QRubberBand::Rectangle);
    const QRect rectangle = pixels.intersected(QRectF(QPointF(), view_.size())).toAlignedRect();
    band_->setGeometry(QRect(view_.mapToGlobal(rectangle.topLeft()), rectangle.size()));
    const QRect all(QPoint(), rectangle.size());
    band_->setMask(QRegion(all) - all.adjusted(framePx, framePx, -framePx, -framePx));
    band_->show();
}

void BoxSelection::hide() {
    if (band_) band_->hide();
}

bool BoxSelection::shown() const { return band_ && band_->isVisible(); }

}  // namespace noonmark
