#include "app/window/view/view_presets.h"

#include <algorithm>
#include <cmath>

#include "app/window/actions/make_action.h"
#include "app/window/time/time_display.h"
#include "app/window/view/view_panel.h"
#include "render/view/camera_control.h"

namespace noonmark {

namespace {

constexpr double elevationPitchDeg = 8;  // over the roofs in front

double opposite(double azimuthDeg) { return std::fmod(azimuthDeg + 180, 360); }

}  // namespace

CameraPose lookFromSide(CameraPose pose, double fromDeg) {
    pose.headingDeg = opposite(fromDeg);
    pose.pitchDeg = elevationPitchDeg;
    return pose;
}

CameraPose lookFromSun(CameraPose pose, const SunAtMoment& sun) {
    pose.headingDeg = opposite(sun.azimuthDeg);
    pose.pitchDeg = std::clamp(sun.altitudeDeg, CameraLimits::lowestPitchDeg, 90.0);
    return pose;
}

ViewPresets::ViewPresets(ViewPanel& panel, const TimeDisplay& time) : panel_(panel), time_(time) {
    addSide(tr("From the &south"), QKeySequence(tr("Shift+S")), 180);
    addSide(tr("From the &east"), QKeySequence(tr("Shift+E")), 90);
    addSide(tr("From the &north"), QKeySequence(tr("Shift+N")), 0);
    addSide(tr("From the &west"), QKeySequence(tr("Shift+W")), 270);
    QAction* sun = makeAction(this, tr("From the s&un"), Qt::Key_U,
                              tr("As the sun sees the city at the date and time below the view: what is "
                                 "visible is sunlit"),
                              "sun");
    connect(sun, &QAction::triggered, this, &ViewPresets::showSunsView);
    actions_ << sun;
}

void ViewPresets::addSide(const QString& text, const QKeySequence& keys, double fromDeg) {
    QAction* action = makeAction(this, text, keys, tr("The same ground from this side, nearly level"));
    if (actions_.isEmpty()) action->setIcon(makeIcon(QStringLiteral("front-view")));
    connect(action, &QAction::triggered, this,
            [this, fromDeg] { go(lookFromSide(panel_.view().pose(), fromDeg)); });
    actions_ << action;
}

void ViewPresets::showSunsView() {
    const SunAtMoment& sun = time_.sun();
    if (sun.isUp()) return go(lookFromSun(panel_.view().pose(), sun));
    panel_.messages().showNote(
        tr("The sun is below the horizon at this date and time. Move the time below the view."));
}

// The eye stays above the ground, as while the camera is moved by hand.
void ViewPresets::go(const CameraPose& pose) {
    const auto ground = [this](glm::dvec2 point) { return panel_.navigator().scene().groundAt(point); };
    panel_.view().setPose(keepAboveGround(pose, computeLimits(panel_.view().viewBounds()), ground));
}

}  // namespace noonmark
