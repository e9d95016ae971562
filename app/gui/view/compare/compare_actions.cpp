#include "app/gui/view/compare/compare_actions.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/project/project_session.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/time_display.h"
#include "app/gui/view/panel/view_panel.h"
#include "render/view/traced_city.h"

namespace noonmark {

OtherScenario::OtherScenario(Workbench& workbench, ViewPanel& panel, QObject* parent)
    : QObject(parent), workbench_(workbench), panel_(panel) {
    // Queued: once the view has the city.
    connect(
        &workbench_, &Workbench::cityShown, this, [this] { start(); }, Qt::QueuedConnection);
    connect(&workbench_.session(), &ProjectSession::renamed, this,
            [this](ProjectPart part, const std::string& from, const std::string& to) {
                if (part == ProjectPart::scenario && name_ == from) name_ = to;
            });
}

void OtherScenario::show(const std::string& scenario) {
    name_ = scenario;
    start();
}

void OtherScenario::clear() {
    name_.clear();
    city_.reset();
    preparing_.drop();
    panel_.view().other().clear();
}

void OtherScenario::start() {
    const auto arrays = panel_.view().arrays();
    if (name_.empty() || !arrays) return;
    preparing_.drop();
    auto city = workbench_.session().cityOf(name_);
    if (!city) return take(nullptr, tl::make_unexpected(city.error()));
    if (*city == city_ && panel_.view().other().arrays() == arrays) return Q_EMIT changed();
    preparing_.start<Prepared>(
        tr("Showing %1").arg(QString::fromStdString(name_)),
        [city = *city, arrays, crowns = workbench_.city()->crowns](Progress&, const std::stop_token& stop) {
            return prepare(*city, *arrays, crowns, stop);
        },
        [this, city = *city, arrays](Result<Prepared> prepared) {
            if (arrays != panel_.view().arrays()) return start();
            take(city, std::move(prepared));
        });
}

Result<OtherScenario::Prepared> OtherScenario::prepare(const City& city, const CityArrays& arrays,
                                                       std::shared_ptr<const CrownRays> crowns,
                                                       const std::stop_token& stop) {
    Prepared prepared{computeDifference(arrays, city), {}, {}};
    if (!drawsInSoftware()) return prepared;
    auto scene = RayScene::over(city, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    prepared.scene = *std::move(scene);
    auto rays = findCrownRays(city, std::move(crowns), stop);
    if (!rays) return tl::make_unexpected(rays.error());
    prepared.crowns = *std::move(rays);
    return prepared;
}

void OtherScenario::take(std::shared_ptr<const City> city, Result<Prepared> prepared) {
    if (!prepared) {
        clear();
        return Q_EMIT failed(prepared.error());
    }
    city_ = std::move(city);
    panel_.view().showOther(prepared->changes, std::move(prepared->scene), city_->buildings);
    panel_.view().other().showTrees(city_->trees, std::move(prepared->crowns));
    Q_EMIT changed();
}

CompareStrip::CompareStrip(ProjectSession& session, QWidget* parent)
    : QWidget(parent), session_(session), other_(new QComboBox), note_(new QLabel), displayed_(new QLabel) {
    setObjectName(QStringLiteral("compareStrip"));
    other_->setObjectName(QStringLiteral("compareOther"));
    other_->setToolTip(tr("The scenario on the left, or under the key C"));
    other_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    displayed_->setToolTip(tr("The displayed scenario, which edits change"));
    note_->setObjectName(QStringLiteral("compareNote"));
    note_->setAlignment(Qt::AlignCenter);
    auto* close = new QToolButton;
    close->setText(QStringLiteral("×"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Ends the comparison in the view"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 2, 4, 2);
    row->addWidget(other_);
    row->addWidget(note_, 1);
    row->addWidget(displayed_);
    row->addWidget(close);
    connect(other_, &QComboBox::activated, this,
            [this] { Q_EMIT otherChosen(other_->currentData().toString().toStdString()); });
    connect(close, &QToolButton::clicked, this, &CompareStrip::closed);
    connect(&session_, &ProjectSession::changed, this, &CompareStrip::fill);
    fill();
}

void CompareStrip::fill() {
    const QVariant before = other_->currentData();
    const QSignalBlocker block(other_);
    other_->clear();
    for (const std::string& name : listOthers(session_))
        other_->addItem(scenarioName(name), QString::fromStdString(name));
    other_->setCurrentIndex(std::max(0, other_->findData(before)));
    displayed_->setText(scenarioName(session_.scenario()));
}

void CompareStrip::setOther(const std::string& scenario) {
    const QSignalBlocker block(other_);
    if (const int at = other_->findData(QString::fromStdString(scenario)); at >= 0)
        other_->setCurrentIndex(at);
}

void CompareStrip::setNote(const QString& note) { note_->setText(note); }

std::vector<std::string> listOthers(const ProjectSession& session) {
    std::vector<std::string> names;
    if (session.scenario() != existingCity) names.emplace_back(existingCity);
    for (const Scenario& scenario : session.project().scenarios)
        if (scenario.name != session.scenario()) names.push_back(scenario.name);
    return names;
}

namespace {

constexpr double dividerReachPx = 8;
constexpr double minShare = 0.02;  // so that the divider can be found again

}  // namespace

DividerHandle::DividerHandle(CityView& view, ViewNavigator& navigator, QObject* parent)
    : QObject(parent), view_(view), navigator_(navigator) {
    navigator_.addTarget(*this);
    connect(&navigator_, &ViewNavigator::hovered, this, &DividerHandle::showCursor);
}

DividerHandle::~DividerHandle() { navigator_.removeTarget(*this); }

void DividerHandle::setActive(bool active) {
    active_ = active;
    if (!active) restoreCursor();
}

bool DividerHandle::isAt(QPointF pixel) const {
    return active_ && std::abs(pixel.x() - view_.sides().divider * view_.width()) <= dividerReachPx;
}

bool DividerHandle::grab(QPointF pixel) { return isAt(pixel); }

void DividerHandle::dragTo(QPointF pixel) {
    ViewSides sides = view_.sides();
    sides.divider = std::clamp(pixel.x() / std::max(1, view_.width()), minShare, 1 - minShare);
    view_.setSides(sides);
}

// Tools have cursors of their own, which return.
void DividerHandle::showCursor(QPointF pixel) {
    if (!isAt(pixel)) return restoreCursor();
    if (before_) return;
    before_ = view_.cursor();
    view_.setCursor(Qt::SplitHCursor);
}

void DividerHandle::restoreCursor() {
    if (before_) view_.setCursor(*before_);
    before_.reset();
}

namespace {

QAction* makeWay(QObject* owner, const QString& text, const QKeySequence& keys, const QString& tip,
                 const char* name) {
    QAction* action = makeAction(owner, text, keys, tip);
    action->setObjectName(QString::fromLatin1(name));
    action->setCheckable(true);
    return action;
}

}  // namespace

CompareActions::CompareActions(Workbench& workbench, ViewPanel& panel, TimeDisplay& time)
    : workbench_(workbench),
      panel_(panel),
      time_(time),
      other_(workbench, panel),
      divider_(panel.view(), panel.navigator()),
      strip_(new CompareStrip(workbench.session())),
      beside_(makeWay(this, tr("Scenarios side by side"), QKeySequence(tr("Shift+C")),
                      tr("Two scenarios with one camera and at one time, the other one on the left"),
                      "compareBeside")),
      swipe_(makeWay(this, tr("Swipe between scenarios"), QKeySequence(tr("Shift+D")),
                     tr("Drag the line in the view: the other scenario lies to its left"), "compareSwipe")),
      flicker_(makeWay(this, tr("Show the other scenario"), QKeySequence(tr("C")),
                       tr("Press again for the displayed scenario: what differs flickers"),
                       "compareFlicker")) {
    panel_.addStrip(strip_);
    strip_->hide();
    for (QAction* way : {beside_, swipe_, flicker_})
        connect(way, &QAction::triggered, this, [this, way](bool on) { begin(way, on); });
    connect(strip_, &CompareStrip::otherChosen, &other_, &OtherScenario::show);
    connect(strip_, &CompareStrip::closed, this, &CompareActions::end);
    connect(&other_, &OtherScenario::changed, this, &CompareActions::layOut);
    connect(&other_, &OtherScenario::failed, this, [this](const Error& error) {
        end();
        if (!isCancelled(error)) panel_.messages().showError(error);
    });
    connect(&workbench_.session(), &ProjectSession::changed, this, &CompareActions::follow);
    connect(&workbench_, &Workbench::projectOpened, this, &CompareActions::end);
    for (auto signal : {&Workbench::answered, &Workbench::answerUpdated})
        connect(&workbench_, signal, this, &CompareActions::showSides);
    panel_.results().whenShown([this] { strip_->setNote(describe()); });
}

CompareActions::~CompareActions() { panel_.results().whenShown({}); }

// The baseline of the comparison is the first choice for the other scenario.
void CompareActions::begin(QAction* way, bool on) {
    if (!on) return end();
    for (QAction* one : {beside_, swipe_, flicker_}) one->setChecked(one == way);
    const std::vector<std::string> others = listOthers(workbench_.session());
    if (others.empty() || !workbench_.city()) {
        end();
        return panel_.messages().showNote(
            tr("There is only one scenario. Change a building or design a tower, then compare"));
    }
    const std::string& baseline = workbench_.session().baseline();
    for (const std::string& name : {other_.name(), baseline})
        if (std::ranges::find(others, name) != others.end()) return other_.show(name);
    other_.show(others.front());
}

std::string CompareActions::choice() const {
    for (const QAction* way : {beside_, swipe_, flicker_})
        if (way->isChecked() && !other_.name().empty())
            return way->objectName().toStdString() + ' ' + other_.name();
    return {};
}

void CompareActions::restore(const std::string& choice) {
    const std::size_t space = choice.find(' ');
    if (space == std::string::npos) return;
    const std::string name = choice.substr(space + 1);
    const std::vector<std::string> others = listOthers(workbench_.session());
    if (!workbench_.city() || std::ranges::find(others, name) == others.end()) return;
    for (QAction* way : {beside_, swipe_, flicker_})
        if (way->objectName().toStdString() == choice.substr(0, space)) {
            way->setChecked(true);
            other_.show(name);
        }
}

void CompareActions::end() {
    for (QAction* way : {beside_, swipe_, flicker_}) way->setChecked(false);
    strip_->hide();
    divider_.setActive(false);
    panel_.setComparison({});
    panel_.view().setSides({});
    stepForward();
    panel_.results().setSides(std::nullopt);
    time_.setOtherCity(nullptr);
    other_.clear();
}

// The displayed scenario may have become the other one, or the other one may be changed or gone.
void CompareActions::follow() {
    if (other_.name().empty()) return;
    const std::vector<std::string> others = listOthers(workbench_.session());
    if (others.empty()) return end();
    const bool there = std::ranges::find(others, other_.name()) != others.end();
    other_.show(there ? other_.name() : others.front());
}

void CompareActions::layOut() {
    strip_->setOther(other_.name());
    strip_->show();
    time_.setOtherCity(other_.city());
    ViewSides sides = panel_.view().sides();
    if (sides.layout != SideLayout::swipe || sides.divider == 1) sides.divider = 0.5;
    sides.layout = beside_->isChecked() ? SideLayout::beside : SideLayout::swipe;
    if (flicker_->isChecked()) sides.divider = 1;
    divider_.setActive(swipe_->isChecked());
    const double widthBefore = panel_.view().lens().widthPx;
    panel_.view().setSides(sides);
    sides.layout == SideLayout::beside ? stepBack(widthBefore) : stepForward();
    panel_.setComparison(nameSides());
    showSides();
}

// A half shows half of the width: from farther away it still shows all that was in sight, so that no place is
// cut at the seam.
void CompareActions::stepBack(double widthBefore) {
    const double narrower = widthBefore / panel_.view().lens().widthPx;
    if (step_ || narrower <= 1) return;
    const CameraPose before = panel_.view().pose();
    CameraPose after = before;
    after.distanceM *= narrower;
    panel_.view().setPose(after);
    step_ = Step{before, panel_.view().pose()};
}

// Unless the camera has moved since.
void CompareActions::stepForward() {
    if (step_ && panel_.view().pose() == step_->after) panel_.view().setPose(step_->before);
    step_.reset();
}

QString CompareActions::nameSides() const {
    const QString left = scenarioName(other_.name());
    if (flicker_->isChecked()) return left;
    return tr("Left: %1. Right: %2").arg(left, scenarioName(workbench_.session().scenario()));
}

namespace {

// Of a comparison the shadow in its scenario.
std::optional<GroundAnswer> groundOf(const std::shared_ptr<const Answer>& answer) {
    if (!answer) return std::nullopt;
    if (const auto impact = contentOf<ImpactAnswer>(answer))
        return makeGroundAnswer(impact, impact->study.after);
    const auto layer = viewerOf(*answer).layer(answer);
    const auto* ground = layer ? std::get_if<GroundAnswer>(&*layer) : nullptr;
    return ground ? std::optional(*ground) : std::nullopt;
}

}  // namespace

void CompareActions::showSides() {
    if (panel_.view().sides().layout != SideLayout::one) panel_.results().setSides(findSides());
}

std::optional<ComparedSides> CompareActions::findSides() {
    ComparedSides sides{{workbench_.session().scenario(), {}}, {other_.name(), {}}};
    const auto answer = workbench_.answer() ? workbench_.answer() : workbench_.past();
    const auto shown = answer && !viewerOf(*answer).layer ? workbench_.behind() : answer;
    if (shown && shown->points()) return std::nullopt;
    if (!shown || !shown->settings()) return sides;
    if (shown != workbench_.past()) sides.displayed.ground = groundOf(shown);
    const auto impact = contentOf<ImpactAnswer>(shown);
    if (impact && impact->from == sides.other.scenario)
        sides.other.ground = makeGroundAnswer(impact, impact->study.before);
    else
        sides.other.ground = groundOf(workbench_.findAnswer(sides.other.scenario, *shown));
    return sides;
}

QString CompareActions::describe() const {
    if (flicker_->isChecked()) return tr("shown: %1").arg(scenarioName(other_.name()));
    if (time_.showsMoment()) return tr("sun and shadow of the same moment");
    if (panel_.results().showsExplored())
        return tr("explored: %1 only").arg(scenarioName(workbench_.session().scenario()));
    if (!panel_.results().showsPlaces() && !panel_.results().showsAnswer()) return {};
    if (!workbench_.answer() && !workbench_.past()) return {};
    QStringList missing;
    for (const std::string& scenario : panel_.results().missingSides())
        missing << QString::fromStdString(scenario);
    if (missing.empty()) return tr("the same question, in the same colours");
    return tr("not measured yet: %1 (Scenario > Measure all scenarios)")
        .arg(missing.join(QStringLiteral(", ")));
}

}  // namespace noonmark
