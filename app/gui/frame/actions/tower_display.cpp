#include "app/gui/frame/actions/tower_display.h"

#include <QSettings>

#include "app/gui/base/looks/height_reference.h"
#include "app/gui/base/widgets/make_action.h"
#include "app/gui/tools/editing/edit_tools.h"

namespace noonmark {

namespace {

const QString storeyLinesKey = QStringLiteral("storeyLines");
const QString liveChangeKey = QStringLiteral("liveChange");

}  // namespace

TowerDisplay::TowerDisplay(QSettings& settings, EditTools& tools)
    : settings_(settings),
      tools_(tools),
      storeyLines_(makeAction(this, tr("Store&y lines"), {},
                              tr("Lines at the floors of proposed towers, and of imported buildings whose "
                                 "storey height is known"))),
      aboveDatum_(makeAction(this, tr("&Heights above datum"), {},
                             tr("Heights of buildings above the vertical zero of the project's terrain "
                                "instead of above the ground under each building, as shown and as typed"))) {
    for (QAction* one : {storeyLines_, aboveDatum_}) one->setCheckable(true);
    storeyLines_->setChecked(settings_.value(storeyLinesKey, true).toBool());
    aboveDatum_->setChecked(readHeightReference(settings_) == HeightReference::datum);
    connect(storeyLines_, &QAction::toggled, this, &TowerDisplay::setStoreyLines);
    connect(aboveDatum_, &QAction::toggled, this, &TowerDisplay::setAboveDatum);
    tools_.changeAction().setChecked(settings_.value(liveChangeKey, true).toBool());
    connect(&tools_.changeAction(), &QAction::toggled, this,
            [this](bool on) { settings_.setValue(liveChangeKey, on); });
    tools_.setStoreyLines(storeyLines_->isChecked());
    applyHeightReference(readHeightReference(settings_));
    tools_.heightReferenceChanged();
}

void TowerDisplay::setStoreyLines(bool on) {
    settings_.setValue(storeyLinesKey, on);
    tools_.setStoreyLines(on);
}

void TowerDisplay::setAboveDatum(bool on) {
    const HeightReference reference = on ? HeightReference::datum : HeightReference::ground;
    saveHeightReference(reference, settings_);
    applyHeightReference(reference);
    tools_.heightReferenceChanged();
}

}  // namespace noonmark
