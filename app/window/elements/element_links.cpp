#include "app/window/elements/element_links.h"

#include <algorithm>
#include <cmath>

#include "app/window/elements/elements_dock.h"
#include "app/window/view/view_panel.h"

namespace noonmark {

namespace {
constexpr double farthestViewM = 80;
constexpr double pitchTowardsWallDeg = 20;
}  // namespace

ElementLinks::ElementLinks(ElementsDock& dock, ViewPanel& panel) : dock_(dock), panel_(panel) {
    connect(&dock_, &ElementsDock::pointedAt, this,
            [this](const std::vector<std::size_t>& elements) { panel_.view().tiles().highlight(elements); });
    connect(&dock_, &ElementsDock::wanted, this, &ElementLinks::goTo);
    connect(&panel_.navigator(), &ViewNavigator::clicked, this, &ElementLinks::click);
}

// Looks at the point from in front of its wall.
void ElementLinks::goTo(std::size_t element) {
    const MeasuredElement& at = dock_.model().map()->elements[element];
    CameraPose pose = panel_.view().pose();
    pose.target = glm::dvec3(at.position);
    pose.distanceM = std::min(pose.distanceM, farthestViewM);
    if (!std::isnan(at.azimuthDeg)) {
        pose.headingDeg = std::fmod(at.azimuthDeg + 180, 360);
        pose.pitchDeg = pitchTowardsWallDeg;
    }
    panel_.view().setPose(pose);
}

void ElementLinks::click(QPointF pixel) {
    if (panel_.drawing() || panel_.view().tiles().tiles().empty()) return;
    const auto pick = panel_.navigator().pickAt(pixel);
    const auto element = pick ? panel_.results().elementAt(pick->position) : std::nullopt;
    if (element) dock_.select(*element);
}

}  // namespace noonmark
