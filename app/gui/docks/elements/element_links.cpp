#include "app/gui/docks/elements/element_links.h"

#include <cmath>

#include "app/gui/docks/elements/elements_dock.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/panel/wall_view.h"

namespace noonmark {

ElementLinks::ElementLinks(ElementsDock& dock, ViewPanel& panel) : dock_(dock), panel_(panel) {
    connect(&dock_, &ElementsDock::pointedAt, this, [this](const std::vector<std::size_t>& elements) {
        if (panel_.results().showsElements()) panel_.view().tiles().highlight(elements);
    });
    connect(&dock_, &ElementsDock::wanted, this, &ElementLinks::goTo);
    connect(&panel_.navigator(), &ViewNavigator::clicked, this, &ElementLinks::click);
}

void ElementLinks::goTo(std::size_t element) {
    const MeasuredElement& at = dock_.model().map()->elements[element];
    const auto azimuth = std::isnan(at.azimuthDeg) ? std::nullopt : std::optional(at.azimuthDeg);
    panel_.view().setPose(faceWall(panel_.view().pose(), glm::dvec3(at.position), azimuth));
}

void ElementLinks::click(QPointF pixel) {
    if (panel_.drawing() || panel_.view().tiles().tiles().empty()) return;
    const auto pick = panel_.navigator().pickAt(pixel);
    const auto element = pick ? panel_.results().elementAt(pick->position) : std::nullopt;
    if (element) dock_.select(*element);
}

}  // namespace noonmark
