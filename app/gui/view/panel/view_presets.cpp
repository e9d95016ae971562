#include "app/gui/view/panel/view_presets.h"

#include <QAction>
#include <QActionGroup>
#include <algorithm>
#include <cmath>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/view/panel/time_display.h"
#include "app/gui/view/panel/view_panel.h"
#include "render/view/camera_control.h"

namespace noonmark {

CameraPose faceWall(CameraPose pose, glm::dvec3 place, std::optional<double> azimuthDeg) {
    constexpr double farthestViewM = 80, pitchTowardsWallDeg = 20;
    pose.target = place;
    pose.distanceM = std::min(pose.distanceM, farthestViewM);
    if (!azimuthDeg) return pose;
    pose.headingDeg = std::fmod(*azimuthDeg + 180, 360);
    pose.pitchDeg = pitchTowardsWallDeg;
    return pose;
}

namespace {

constexpr double overRoofsDeg = 8;
constexpr double groundBelowMiddle =
    0.22;  // of the distance: the ground lies at the lower fifth of the picture

// With its target on the ground, from which a level parallel view may have raised it.
CameraPose groundedPose(ViewPanel& panel) {
    CameraPose pose = panel.view().pose();
    pose.target.z = panel.navigator().scene().groundAt({pose.target.x, pose.target.y});
    return pose;
}

double opposite(double azimuthDeg) { return std::fmod(azimuthDeg + 180, 360); }

}  // namespace

CameraPose lookFromSide(CameraPose pose, double fromDeg) {
    pose.headingDeg = opposite(fromDeg);
    const bool parallel = pose.isParallel();
    pose.pitchDeg = parallel ? 0 : overRoofsDeg;
    if (parallel) pose.target.z += groundBelowMiddle * pose.distanceM;
    return pose;
}

CameraPose lookFromSun(CameraPose pose, const SunAtMoment& sun) {
    pose.headingDeg = opposite(sun.azimuthDeg);
    pose.pitchDeg = std::clamp(sun.altitudeDeg, CameraLimits::minPitchDeg, 90.0);
    return pose;
}

ViewPresets::ViewPresets(ViewPanel& panel, const TimeDisplay& time)
    : panel_(panel),
      time_(time),
      parallel_(makeAction(this, tr("Parallel pro&jection"), Qt::Key_O,
                           tr("Orthographic, as in plans and elevations: lengths across the view are to "
                              "scale everywhere"))) {
    parallel_->setCheckable(true);
    connect(parallel_, &QAction::triggered, this, [this](bool on) {
        panel_.navigator().setProjection(on ? Projection::parallel : Projection::perspective);
    });
    connect(&panel_.view(), &CityView::poseChanged, parallel_,
            [this] { parallel_->setChecked(panel_.view().pose().isParallel()); });
    QAction* plan =
        makeAction(this, tr("&Plan"), QKeySequence(tr("Shift+P")),
                   tr("The same ground from straight above, north up, in parallel projection"), "top-view");
    connect(plan, &QAction::triggered, this, &ViewPresets::showPlan);
    actions_ << plan;
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
    QAction* action = makeAction(this, text, keys,
                                 tr("The same ground from this side; an elevation in parallel projection"));
    if (actions_.size() == 1) action->setIcon(makeIcon(QStringLiteral("front-view")));
    connect(action, &QAction::triggered, this,
            [this, fromDeg] { panel_.navigator().go(lookFromSide(groundedPose(panel_), fromDeg)); });
    actions_ << action;
}

void ViewPresets::showSunsView() {
    const SunAtMoment& sun = time_.sun();
    if (sun.isUp()) return panel_.navigator().go(lookFromSun(groundedPose(panel_), sun));
    panel_.messages().showNote(
        tr("The sun is below the horizon at this date and time. Move the time below the view."));
}

void ViewPresets::showPlan() {
    CameraPose pose = groundedPose(panel_);
    pose.projection = Projection::parallel;
    pose.pitchDeg = 90;
    pose.headingDeg = 0;
    panel_.navigator().go(pose);
}

ModeSwitch::ModeSwitch(QObject* parent) : QObject(parent), group_(new QActionGroup(this)) {
    makeAction(ViewMode::exploration, Qt::Key_F5);
    makeAction(ViewMode::analysis, Qt::Key_F6);
    makeAction(ViewMode::review, Qt::Key_F7);
    actions()[int(mode_)]->setChecked(true);
}

void ModeSwitch::makeAction(ViewMode mode, const QKeySequence& keys) {
    QAction* action = group_->addAction(nameOf(mode));
    action->setObjectName(QStringLiteral("mode%1").arg(int(mode)));
    const char* const icons[] = {"sun", "analyse", "review"};
    action->setIcon(makeIcon(QString::fromLatin1(icons[int(mode)])));
    action->setCheckable(true);
    action->setShortcut(keys);
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(describeMeasure(mode), keys.toString(QKeySequence::NativeText)));
    action->setStatusTip(describeMeasure(mode).replace(QLatin1Char('\n'), QLatin1Char(' ')));
    connect(action, &QAction::triggered, this, [this, mode] { setMode(mode); });
}

QList<QAction*> ModeSwitch::actions() const { return group_->actions(); }

void ModeSwitch::setMode(ViewMode mode) {
    actions()[int(mode)]->setChecked(true);
    if (mode == mode_) return;
    mode_ = mode;
    Q_EMIT changed(mode);
}

void ModeSwitch::showStudies() {
    if (mode_ == ViewMode::exploration) setMode(ViewMode::analysis);
}

}  // namespace noonmark
