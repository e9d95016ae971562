#include "app/gui/docks/point/dome_display.h"

#include <QSettings>
#include <QTimer>
#include <glm/geometric.hpp>

#include "app/gui/base/widgets/make_action.h"
#include "app/gui/docks/point/point_inspector.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/time_display.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/time/time_strip.h"

namespace noonmark {

namespace {

const QString sunDomeKey = QStringLiteral("sunDome");
constexpr int domeRestMs = 200;

}  // namespace

DomeDisplay::DomeDisplay(QSettings& settings, Workbench& workbench, ViewPanel& panel, const TimeDisplay& time,
                         const PointInspector& point)
    : settings_(settings),
      workbench_(workbench),
      panel_(panel),
      time_(time),
      action_(makeAction(this, tr("Sun path dome"), Qt::Key_D,
                         tr("The sun's paths of the months and the hours on a dome around what the camera "
                            "looks at, or around the pin of the dock Point"))),
      rest_(new QTimer(this)) {
    rest_->setSingleShot(true);
    rest_->setInterval(domeRestMs);
    action_->setCheckable(true);
    action_->setChecked(settings_.value(sunDomeKey, false).toBool());
    connect(action_, &QAction::toggled, this, &DomeDisplay::setShown);
    connect(rest_, &QTimer::timeout, this, &DomeDisplay::settle);
    connect(&time_, &TimeDisplay::sunChanged, this, &DomeDisplay::followSun);
    connect(&panel_.view(), &CityView::poseChanged, this, &DomeDisplay::followCamera);
    connect(&point, &PointInspector::marked, this, &DomeDisplay::followCamera);
}

void DomeDisplay::setShown(bool shown) {
    settings_.setValue(sunDomeKey, shown);
    if (shown) return followSun();
    rest_->stop();
    place_.reset();
    panel_.view().dome().show({});
    panel_.view().dome().showSun({});
}

// Paths are computed again only if the sky is another one: a slider moves the sun alone.
void DomeDisplay::followSun() {
    if (!action_->isChecked() || !workbench_.city()) return;
    const auto now = question();
    if (!now) return;
    if (asked_ != *now) {
        auto paths = computeSunPaths(*now);
        if (!paths) return panel_.messages().showError(paths.error());
        paths_ = *std::move(paths);
        asked_ = *now;
        place_.reset();
    }
    place_ ? drawSun() : settle();
}

void DomeDisplay::followCamera() {
    if (!place_) return;
    const DomeDrift drift = compareDomes(*place_, wantedPlace());
    if (drift == DomeDrift::large) return settle();
    drift == DomeDrift::small ? rest_->start() : rest_->stop();
}

void DomeDisplay::settle() {
    rest_->stop();
    place_ = wantedPlace();
    draw();
}

void DomeDisplay::draw() {
    panel_.view().dome().show(drawDome(paths_, asked_->observer.frameFromPlace, *place_));
    drawSun();
}

void DomeDisplay::drawSun() {
    if (!time_.showsMoment()) return panel_.view().dome().showSun({});
    const auto path = computeSunPath(*asked_, panel_.time().look().date);
    if (!path) return panel_.view().dome().showSun({});
    panel_.view().dome().showSun(drawDomeSun(*path, glm::normalize(time_.sun().towards), *place_));
}

DomePlace DomeDisplay::wantedPlace() const {
    const CameraPose& pose = panel_.view().pose();
    const double groundM = panel_.navigator().scene().groundAt({pose.target.x, pose.target.y});
    return placeDome(pose, panel_.view().lens(), groundM, panel_.view().overlay().pin());
}

Result<SunPathQuestion> DomeDisplay::question() const {
    const StudySettings& settings = workbench_.document().settings();
    const auto zone = Zone::named(settings.period.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const TimeLook& look = panel_.time().look();
    const auto at = std::chrono::floor<std::chrono::seconds>(zone->instantAt(look.date, look.at));
    return SunPathQuestion{makeObserver(workbench_.city()->city(), settings), settings.period.zone,
                           look.date.year(), zone->offsetAt(at), settings.period.refraction};
}

}  // namespace noonmark
