#include "app/gui/docks/elements/element_picking.h"

#include <cmath>

#include "app/gui/docks/point/picked_point.h"
#include "app/gui/docks/study_form/element_form.h"
#include "app/gui/docks/study_form/face_form.h"
#include "app/gui/docks/study_form/point_list_form.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"

namespace noonmark {

namespace {

void addPickedFace(FaceForm& form, const City& city, const Pick& pick) {
    if (!pick.building || *pick.building >= city.buildings.size()) return;
    const auto face = findFaceAt(*city.buildings[*pick.building], pick.position, glm::dvec3(pick.normal));
    if (face) form.addFace(QString::fromStdString(*face));
}

void addPickedPoint(PointListForm& form, const City& city, const Pick& pick) {
    const PointQuestion question = questionAt(city, pick);
    const auto rounded = [](std::optional<double> value, double to) {
        return value ? std::optional(std::round(*value / to) * to) : value;
    };
    form.add({{}, question.at, rounded(question.heightM, 0.01), rounded(question.facingDeg, 0.1)});
}

}  // namespace

ElementPicking::ElementPicking(Workbench& workbench, ViewPanel& panel)
    : workbench_(workbench), panel_(panel) {
    connect(&panel_.navigator(), &ViewNavigator::clicked, this, &ElementPicking::click);
}

void ElementPicking::serve(ElementForm& form) {
    forms_.push_back(&form);
    connect(&form.faces(), &FaceForm::pickingBegan, this, [this, &form] { begin(form, true); });
    connect(&form.list(), &PointListForm::pickingBegan, this, [this, &form] { begin(form, false); });
}

void ElementPicking::begin(const ElementForm& form, bool faces) {
    for (ElementForm* other : forms_) {
        if (other != &form || !faces) other->faces().endPicking();
        if (other != &form || faces) other->list().endPicking();
    }
    panel_.messages().showNote(faces ? tr("Click walls in the view to choose their faces.")
                                     : tr("Click the ground, roofs or walls in the view to add points."));
}

void ElementPicking::click(QPointF pixel) {
    if (panel_.drawing() || !workbench_.city()) return;
    for (ElementForm* form : forms_) {
        if (!form->faces().picking() && !form->list().picking()) continue;
        const auto pick = panel_.navigator().pickAt(pixel);
        if (!pick) return;
        const City& city = workbench_.city()->city();
        form->faces().picking() ? addPickedFace(form->faces(), city, *pick)
                                : addPickedPoint(form->list(), city, *pick);
    }
}

}  // namespace noonmark
