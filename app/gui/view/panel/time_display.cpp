#include "app/gui/view/panel/time_display.h"

#include <QDate>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/map_layer.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/panel/view_presets.h"
#include "app/gui/view/time/time_strip.h"
#include "app/report/sheets/study_text.h"
#include "core/sun/civil_time.h"

namespace noonmark {

namespace {

constexpr int movingSize = 1024, restingSize = 4096;  // texels a side
constexpr int sunRestMs = 250;
constexpr double lowestSunZ = 0.005;  // a lower sun shades everything but the tops
constexpr double minutesPerWidth = 720, daysPerHeight = 182;

QString describeShare(const ShadowField& field) {
    const ShadowStatistics figures = computeStatistics(field);
    const double share = figures.receiverAreaM2 > 0 ? figures.shadowAreaM2 / figures.receiverAreaM2 : 0;
    return QObject::tr("%1 % in shadow").arg(formatAmount(100 * share));
}

}  // namespace

TimeDisplay::TimeDisplay(Workbench& workbench, const ModeSwitch& mode, ViewPanel& panel,
                         std::shared_ptr<SharedHorizonCache> horizons)
    : workbench_(workbench),
      mode_(mode),
      panel_(panel),
      moments_(std::move(horizons)),
      rest_(new QTimer(this)) {
    rest_->setSingleShot(true);
    rest_->setInterval(sunRestMs);
    connectWorkbench();
    connectView();
    makeActions();
}

void TimeDisplay::connectWorkbench() {
    connect(&workbench_, &Workbench::answered, this, &TimeDisplay::offer);
    connect(&workbench_, &Workbench::ran, this, &TimeDisplay::showPeriod);
    connect(&workbench_.session(), &ProjectSession::baselineChanged, this, &TimeDisplay::offer);
    connect(&workbench_.document(), &StudyDocument::changed, this, &TimeDisplay::offer);
    connect(&workbench_.document(), &StudyDocument::changed, this, &TimeDisplay::followPeriod);
    connect(&mode_, &ModeSwitch::changed, this, [this](ViewMode mode) {
        if (mode != ViewMode::exploration) leavePresent();
        offer();
    });
}

void TimeDisplay::connectView() {
    TimeStrip& strip = panel_.time();
    connect(&strip, &TimeStrip::lookChanged, this, &TimeDisplay::look);
    connect(&strip, &TimeStrip::taken, this, &TimeDisplay::study);
    connect(&moments_, &MomentPreview::changed, this, &TimeDisplay::show);
    connect(&moments_, &MomentPreview::failed, &strip, [&strip](const ShownTime& look, const Error& error) {
        strip.setAnswer(look, QString::fromStdString(error.what));
    });
    connect(&shadow_, &SunShadow::changed, this, [this] {
        const auto map = shadow_.map();
        map ? panel_.view().sun().show(*map) : panel_.view().sun().clear();
    });
    connect(&otherShadow_, &SunShadow::changed, this, [this] {
        const auto map = otherShadow_.map();
        SunLayer& sun = panel_.view().other().sun();
        map ? sun.show(*map) : sun.clear();
    });
    connect(rest_, &QTimer::timeout, this, &TimeDisplay::drawShadow);
    connect(&panel_.view(), &CityView::tracedChanged, this, &TimeDisplay::showSun);
    connect(&panel_.view(), &CityView::treesToggled, this, &TimeDisplay::showSun);
    connect(&panel_.view(), &CityView::poseChanged, this, &TimeDisplay::freeLabel);
    connect(&panel_.view(), &CityView::poseChanged, this, [this] {
        if (showsMoment() && !panel_.view().isTraced()) followCamera();
    });
    connect(&panel_.navigator(), &ViewNavigator::sunDragged, this, &TimeDisplay::turnSun);
}

void TimeDisplay::makeActions() {
    TimeStrip& strip = panel_.time();
    const auto add = [this](const QString& text, const QKeySequence& keys, const QString& tip, auto act) {
        QAction* action = makeAction(this, text, keys, tip);
        connect(action, &QAction::triggered, this, act);
        actions_ << action;
    };
    add(tr("&Play the sun"), QKeySequence(tr("Shift+Space")), tr("Plays or stops the sun and its shadows"),
        [&strip] { strip.setPlaying(!strip.playing()); });
    add(tr("Ten minutes &later"), Qt::Key_Period, tr("The sun ten minutes later"),
        [&strip] { strip.move(10, 0); });
    add(tr("Ten minutes &earlier"), Qt::Key_Comma, tr("The sun ten minutes earlier"),
        [&strip] { strip.move(-10, 0); });
    add(tr("&Next day"), Qt::Key_BracketRight, tr("The sun at the same time of the next day"),
        [&strip] { strip.move(0, 1); });
    add(tr("Previous &day"), Qt::Key_BracketLeft, tr("The sun at the same time of the day before"),
        [&strip] { strip.move(0, -1); });
}

bool TimeDisplay::showsMoment() const { return panel_.time().look().span == ShownSpan::moment; }

void TimeDisplay::showPresent() {
    if (!workbench_.city()) return;
    const StudySettings& settings = workbench_.document().settings();
    const Observer observer = makeObserver(workbench_.city()->city(), settings);
    const auto present = findPresentTime(observer, settings.period, clock_());
    if (!present) return;
    present_ = *present;
    panel_.time().choose(present->look);
    showSun();
}

std::string TimeDisplay::choice() const {
    if (!showsMoment() || showsPresent()) return {};
    const ShownTime& look = panel_.time().look();
    return formatText(look.date) + ' ' + formatText(look.at);
}

bool TimeDisplay::restore(const std::string& choice) {
    const std::size_t space = std::min(choice.find(' '), choice.size());
    const auto date = parseDate(choice.substr(0, space));
    const auto at = parseTimeOfDay(choice.substr(std::min(space + 1, choice.size())));
    if (!date || !at || !workbench_.city()) return false;
    present_.reset();
    panel_.time().choose({ShownSpan::moment, *date, *at});
    return true;
}

// A result is of a period, not of the moment that the window began with.
void TimeDisplay::leavePresent() {
    const auto present = std::exchange(present_, std::nullopt);
    if (present && panel_.time().look() == present->look) showPeriod();
}

// Who runs a question wants to see its answer, whatever moment the strip has shown.
void TimeDisplay::showPeriod() {
    ShownTime look = panel_.time().look();
    look.span = ShownSpan::period;
    panel_.time().choose(inPeriod(look));
}

// Its first day, where the shown one is of no day of it: no other date stands beside that of the result.
ShownTime TimeDisplay::inPeriod(ShownTime look) const {
    const Period& period = workbench_.document().settings().period;
    const std::chrono::sys_days first(period.start), shown(look.date);
    if (shown < first || shown >= first + std::chrono::days(period.days)) look.date = period.start;
    return look;
}

void TimeDisplay::setDesigning(bool designing) {
    if (designing && showsMoment()) {
        beforeDesign_ = Before{panel_.time().look(), present_};
        return showPeriod();
    }
    const auto before = designing ? std::nullopt : std::exchange(beforeDesign_, std::nullopt);
    if (!before || showsMoment()) return;
    present_ = before->present;
    panel_.time().choose(before->look);
}

bool TimeDisplay::showsPresent() const { return present_ && present_->look == panel_.time().look(); }

QString TimeDisplay::moment() const {
    if (!showsMoment()) return {};
    const ShownTime& look = panel_.time().look();
    const QString words = tr("%1. %2").arg(describe(look), describe(sun_));
    return showsPresent() && present_->isNoon
               ? tr("The sun is down or low there now, so this is noon: %1").arg(words)
               : words;
}

void TimeDisplay::offer() {
    if (!workbench_.city()) return;
    const auto study = mode_.mode() != ViewMode::exploration ? workbench_.answerAs<Study>() : nullptr;
    TimeStrip& strip = panel_.time();
    strip.setPeriod(study ? study->settings.period : workbench_.document().settings().period);
    strip.setDayOffered(study != nullptr);
    moments_.look(strip.look());
    moments_.setStudy(study);
    shadow_.setCity({workbench_.city(), &workbench_.city()->city()});
    showSun();
}

// The first day of a study is that of the strip, and so of the next movie, unless the strip is within the
// period already.
void TimeDisplay::followPeriod() {
    const Period& period = workbench_.document().settings().period;
    const std::pair days(period.start, period.days);
    if (const auto before = std::exchange(days_, days); !before || *before == days) return;
    const ShownTime look = inPeriod(panel_.time().look());
    if (look == panel_.time().look()) return;
    const bool isPresent = showsPresent();
    panel_.time().choose(look);
    if (!isPresent) return;
    present_ = PresentTime{panel_.time().look(), false};  // still left for the period by a result
    showSun();
}

// The label beside the cursor stands on the sunny side: of the moment, or that of the equator.
void TimeDisplay::freeLabel() {
    if (!workbench_.city()) return;
    const double latitude = workbench_.city()->city().frame.origin().latDeg;
    const glm::dvec2 sun = showsMoment() ? glm::dvec2(sun_.towards) : glm::dvec2(0, latitude >= 0 ? -1 : 1);
    const double heading = glm::radians(panel_.view().pose().headingDeg);
    const glm::dvec2 right(std::cos(heading), -std::sin(heading)),
        ahead(std::sin(heading), std::cos(heading));
    panel_.cursorLabel().setFreeSide({glm::dot(sun, right), -glm::dot(sun, ahead)});
}

void TimeDisplay::look(const ShownTime& look) {
    if (look.span == ShownSpan::period && look != inPeriod(look)) return panel_.time().choose(inPeriod(look));
    moments_.look(look);
    showSun();
    Q_EMIT momentChanged();
}

void TimeDisplay::show() {
    const auto answer = moments_.answer();
    // Of two cities side by side both have the shadows of the sun: a study's cells are those of one.
    panel_.results().setTime(otherShown_ && showsMoment() ? nullptr : answer);
    if (answer) panel_.time().setAnswer(answer->look, describeShare(answer->field));
}

// Coarsely while the sun moves.
void TimeDisplay::showSun() {
    if (!workbench_.city()) return;
    TimeStrip& strip = panel_.time();
    const CivilDate date = strip.look().date;
    panel_.view().setTreeDay(
        QDate(int(date.year()), int(unsigned(date.month())), int(unsigned(date.day()))).dayOfYear());
    const StudySettings& settings = workbench_.document().settings();
    const auto sun =
        computeSunAt(makeObserver(workbench_.city()->city(), settings), settings.period, strip.look());
    if (!sun) return;
    sun_ = *sun;
    strip.setSun(sun_);
    const bool moment = showsMoment(), visible = moment && sun_.towards.z > lowestSunZ;
    // What is asked for lies over the moment that the window began with, not over one that was chosen.
    panel_.results().setMoment(this->moment(), !showsPresent());
    rest_->stop();
    CityView& view = panel_.view();
    freeLabel();
    Q_EMIT sunChanged();
    const bool traced = view.isTraced();
    view.showTracedSun(traced && visible ? std::optional(glm::normalize(sun_.towards)) : std::nullopt);
    if (!visible || traced) return lookFrom(std::nullopt);
    lookFrom(SunView{glm::normalize(sun_.towards), seenSpace(), movingSize, view.treeDay()});
    rest_->start();
}

void TimeDisplay::showSunFrom(const glm::dvec3& towards, std::function<void()> then) {
    rest_->stop();
    const bool traced = panel_.view().isTraced();
    panel_.view().showTracedSun(traced ? std::optional(glm::normalize(towards)) : std::nullopt);
    if (!traced)
        lookFrom(SunView{glm::normalize(towards), seenSpace(), restingSize, panel_.view().treeDay()});
    awaitShadow(then);
}

void TimeDisplay::awaitShadow(const std::function<void()>& then) {
    constexpr int pauseMs = 5;
    if (!shadow_.busy() && !otherShadow_.busy()) return then();
    QTimer::singleShot(pauseMs, this, [this, then] { awaitShadow(then); });
}

void TimeDisplay::drawShadow() {
    if (showsMoment() && !panel_.time().playing() && sun_.towards.z > lowestSunZ)
        lookFrom(SunView{glm::normalize(sun_.towards), seenSpace(), restingSize, panel_.view().treeDay()});
}

// Finely where it rests. Ground that comes into sight before has coarse shadow, not none; twice as much of it
// is drawn as is seen, so that zooming out asks a few times only.
void TimeDisplay::followCamera() {
    rest_->start();
    const auto& drawn = shadow_.view();
    LitSpace seen = seenSpace();
    if (!drawn || holds(drawn->space.box, seen.box)) return;
    const glm::vec2 margin = (seen.box.high - seen.box.low) / 2.0F;
    const Box2& city = panel_.view().viewBounds().box;
    seen.box.low = glm::max(seen.box.low - margin, city.low);
    seen.box.high = glm::min(seen.box.high + margin, city.high);
    lookFrom(SunView{drawn->towardsSun, seen, movingSize, panel_.view().treeDay()});
}

void TimeDisplay::lookFrom(const std::optional<SunView>& view) {
    shadow_.look(view);
    otherShadow_.look(otherShown_ ? view : std::nullopt);
}

void TimeDisplay::setOtherCity(std::shared_ptr<const City> city) {
    otherShown_ = city != nullptr;
    otherShadow_.setCity(std::move(city));
    show();
    showSun();
}

// The ground in sight, so that close views have fine shadows.
LitSpace TimeDisplay::seenSpace() const {
    const ViewBounds& city = panel_.view().viewBounds();
    const Region seen = panel_.visibleGround();
    Box2 box = seen.polygons.empty() ? city.box : bounds(seen);
    box.low = glm::max(box.low, city.box.low);
    box.high = glm::min(box.high, city.box.high);
    if (box.high.x <= box.low.x || box.high.y <= box.low.y) box = city.box;
    return {box, city.groundM, city.topM};
}

void TimeDisplay::turnSun(QPointF byPx) {
    turned_ += QPointF(byPx.x() * minutesPerWidth / panel_.view().width(),
                       -byPx.y() * daysPerHeight / panel_.view().height());
    const QPointF whole(std::trunc(turned_.x()), std::trunc(turned_.y()));
    turned_ -= whole;
    if (!whole.isNull()) panel_.time().move(int(whole.x()), int(whole.y()));
}

void TimeDisplay::study(const ShownTime& look) {
    StudySettings settings = workbench_.document().settings();
    settings.period = periodOf(look, settings.period);
    panel_.time().setLook(firstShownTime(settings.period));
    moments_.look(panel_.time().look());
    workbench_.document().change(settings, tr("period"));
    workbench_.run();
}

}  // namespace noonmark
