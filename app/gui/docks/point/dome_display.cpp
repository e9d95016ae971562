#include "app/gui/docks/point/dome_display.h"

#include <QLocale>
#include <QSettings>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/docks/point/point_inspector.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/time_display.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/time/time_strip.h"

namespace noonmark {

namespace {

using Stroke = DomeMarks::Stroke;
using Labels = std::vector<NameLabels::Label>;

constexpr double shareOfDistance = 0.27;  // of the camera: near and far side fit the view
constexpr double liftShare = 0.005;       // of the radius: the horizon does not lie in the ground
constexpr double smallMismatch = 0.02, largeMismatch = 0.6;  // of centre or size, shares of the radius
constexpr double largeMismatchSize = 1.5;                    // a ratio of radii
constexpr double tickShare = 0.06, quarterNameShare = 1.2, monthNameShare = 1.06, hourNameShare = 1.04;
constexpr double minHourZ = 0.07;  // of 1: an hour that stays lower has no name
constexpr int horizonStepDeg = 3;

glm::dvec3 onDome(const DomePlace& place, const glm::dvec3& towards, double share = 1) {
    return place.centre + place.radiusM * share * towards;
}

GroundLine lineOf(const SunCurve& curve, const DomePlace& place) {
    GroundLine line{{}, curve.closed};
    for (const glm::dvec3& towards : curve.towards) line.points.emplace_back(onDome(place, towards));
    return line;
}

DomeMarks::Lines linesOf(const std::vector<SunCurve>& curves, const DomePlace& place) {
    DomeMarks::Lines lines;
    for (const SunCurve& curve : curves) lines.push_back(lineOf(curve, place));
    return lines;
}

void append(DomeMarks::Lines& to, DomeMarks::Lines more) { std::ranges::move(more, std::back_inserter(to)); }

void drawHorizon(const glm::dmat3& frameFromPlace, const DomePlace& place, DomeMarks::Net& net) {
    const auto at = [&](double azimuthDeg, double share) {
        return onDome(place, glm::normalize(frameFromPlace * toDirection(Degrees{azimuthDeg}, Degrees{0})),
                      share);
    };
    GroundLine circle{{}, true};
    for (int azimuth = 0; azimuth < 360; azimuth += horizonStepDeg)
        circle.points.emplace_back(at(azimuth, 1));
    DomeMarks::Lines& lines = net.of(Stroke::horizon);
    lines.push_back(std::move(circle));
    const std::array names{QObject::tr("N"), QObject::tr("E"), QObject::tr("S"), QObject::tr("W")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double azimuth = 90.0 * double(i);
        lines.push_back(
            {{glm::vec3(at(azimuth, 1 - tickShare)), glm::vec3(at(azimuth, 1 + tickShare))}, false});
        net.labels.push_back({names[i], at(azimuth, quarterNameShare), true});
    }
}

// Of a sun that does not set, where it stands six hours before or after noon.
glm::dvec3 findMonthName(const std::vector<SunCurve>& curves, bool rising) {
    const std::vector<glm::dvec3>& first = curves.front().towards;
    if (curves.front().closed) return first[rising ? first.size() / 4 : first.size() * 3 / 4];
    return rising ? first.front() : curves.back().towards.back();
}

// Those of solstices and equinoxes, or the others.
void drawMonths(const SunPaths& paths, const DomePlace& place, bool main, DomeMarks::Net& net) {
    for (int month = 1; month <= 12; ++month) {
        const auto& curves = paths.months[std::size_t(month) - 1];
        if (curves.empty() || main != (month % 3 == 0)) continue;
        append(net.of(main ? Stroke::mainMonth : Stroke::month), linesOf(curves, place));
        net.labels.push_back({QLocale().standaloneMonthName(month, QLocale::ShortFormat),
                              onDome(place, findMonthName(curves, month <= 6), monthNameShare), main});
    }
}

std::optional<glm::dvec3> findHourName(const std::vector<SunCurve>& curves) {
    glm::dvec3 highest{0};
    for (const SunCurve& curve : curves)
        for (const glm::dvec3& towards : curve.towards)
            if (towards.z > highest.z) highest = towards;
    return highest.z < minHourZ ? std::nullopt : std::optional(highest);
}

void drawHours(const SunPaths& paths, const DomePlace& place, DomeMarks::Net& net) {
    for (std::size_t hour = 0; hour < paths.hours.size(); ++hour) {
        append(net.of(Stroke::hour), linesOf(paths.hours[hour], place));
        if (const auto at = findHourName(paths.hours[hour]))
            net.labels.push_back({QStringLiteral("%1:00").arg(hour), onDome(place, *at, hourNameShare)});
    }
}

}  // namespace

DomePlace placeDome(const CameraPose& pose, const ViewLens& lens, double groundM,
                    const std::optional<glm::dvec3>& centre) {
    const double narrow = std::min(1.0, lens.widthPx / lens.heightPx);
    DomePlace place{centre.value_or(glm::dvec3(pose.target.x, pose.target.y, groundM)),
                    shareOfDistance * narrow * pose.distanceM};
    place.centre.z += liftShare * place.radiusM;
    return place;
}

DomeMismatch compareDomes(const DomePlace& shown, const DomePlace& wanted) {
    const double off = glm::distance(shown.centre, wanted.centre) / shown.radiusM;
    const double size = std::max(shown.radiusM / wanted.radiusM, wanted.radiusM / shown.radiusM);
    if (off > largeMismatch || size > largeMismatchSize) return DomeMismatch::large;
    return off > smallMismatch || size > 1 + smallMismatch ? DomeMismatch::small : DomeMismatch::none;
}

DomeMarks::Net drawDome(const SunPaths& paths, const glm::dmat3& frameFromPlace, const DomePlace& place) {
    DomeMarks::Net net;
    drawHorizon(frameFromPlace, place, net);
    drawMonths(paths, place, true, net);
    drawHours(paths, place, net);
    drawMonths(paths, place, false, net);
    return net;
}

DomeMarks::Sun drawDomeSun(const std::vector<SunCurve>& path, const glm::dvec3& towardsSun,
                           const DomePlace& place) {
    DomeMarks::Sun sun{linesOf(path, place), {}};
    if (towardsSun.z <= 0) return sun;
    sun.at = onDome(place, towardsSun);
    sun.lines.push_back({{glm::vec3(place.centre), glm::vec3(*sun.at)}, false});
    return sun;
}

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
                            "looks at, or around the pin of the panel Point"))),
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
    const DomeMismatch mismatch = compareDomes(*place_, wantedPlace());
    if (mismatch == DomeMismatch::large) return settle();
    mismatch == DomeMismatch::small ? rest_->start() : rest_->stop();
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
    const ShownTime& look = panel_.time().look();
    const auto at = std::chrono::floor<std::chrono::seconds>(zone->instantAt(look.date, look.at));
    return SunPathQuestion{makeObserver(workbench_.city()->city(), settings), settings.period.zone,
                           look.date.year(), zone->offsetAt(at), settings.period.refraction};
}

}  // namespace noonmark
