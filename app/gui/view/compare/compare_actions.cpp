#include "app/gui/view/compare/compare_actions.h"

#include <QAction>
#include <algorithm>

#include "app/gui/base/widgets/make_action.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/compare/compare_strip.h"
#include "app/gui/view/panel/time_display.h"
#include "app/gui/view/panel/view_panel.h"

namespace noonmark {

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
    panel_.results().whenShown([this] { showPicture(); });
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

void CompareActions::end() {
    for (QAction* way : {beside_, swipe_, flicker_}) way->setChecked(false);
    strip_->hide();
    divider_.setActive(false);
    panel_.setComparison({});
    panel_.view().setSides({});
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
    panel_.view().setSides(sides);
    panel_.setComparison(nameSides());
    showPicture();
}

QString CompareActions::nameSides() const {
    const QString left = QString::fromStdString(other_.name());
    if (flicker_->isChecked()) return left;
    return tr("Left: %1. Right: %2").arg(left, QString::fromStdString(workbench_.session().scenario()));
}

// The other scenario's study in the colours of the displayed one, if it was measured.
void CompareActions::showPicture() {
    if (panel_.view().sides().layout == SideLayout::one) return;
    DrawnCity& other = panel_.view().other();
    other.clearPicture();
    const auto study = findStudy();
    strip_->setNote(describe(study != nullptr));
    if (study) {
        const GroundAnswer answer = makeGroundAnswer(study);
        const Legend legend = panel_.results().studyLegend();
        other.showPicture(makePicture(answer, panel_.legend().measure(), legend), false);
        if (const auto roofs = roofPictureOf(answer, panel_.legend().measure(), legend))
            other.showRoofPicture(*roofs);
    }
}

std::shared_ptr<const Study> CompareActions::findStudy() const {
    const auto shown = workbench_.study();
    if (!shown || !panel_.results().showsStudy()) return nullptr;
    const auto studies = workbench_.studies();
    const auto found = studies.find(other_.name());
    const bool same = found != studies.end() && found->second && found->second->settings == shown->settings;
    return same ? found->second : nullptr;
}

QString CompareActions::describe(bool measured) const {
    if (flicker_->isChecked()) return tr("shown: %1").arg(QString::fromStdString(other_.name()));
    if (time_.showsMoment()) return tr("sun and shadow of the same moment");
    if (panel_.results().showsExplored())
        return tr("explored: %1 only").arg(QString::fromStdString(workbench_.session().scenario()));
    if (!panel_.results().showsStudy()) return {};
    return measured ? tr("the same study, in the same colours")
                    : tr("%1 was not measured yet: Scenario > Measure all scenarios")
                          .arg(QString::fromStdString(other_.name()));
}

}  // namespace noonmark
