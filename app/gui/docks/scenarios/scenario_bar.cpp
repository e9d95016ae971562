#include "app/gui/docks/scenarios/scenario_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "app/gui/base/widgets/name_text.h"
#include "app/gui/session/project/project_session.h"

namespace noonmark {

namespace {

QComboBox* listOf(const char* name, const QString& tip) {
    auto* list = new QComboBox;
    list->setObjectName(QString::fromLatin1(name));
    list->setToolTip(tip);
    list->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    list->setMinimumContentsLength(12);
    list->setFocusPolicy(Qt::TabFocus);
    return list;
}

void fillList(QComboBox& list, const std::vector<std::string>& names, const std::string& now) {
    for (const std::string& name : names) list.addItem(scenarioName(name), QString::fromStdString(name));
    list.setCurrentIndex(std::max(0, list.findData(QString::fromStdString(now))));
}

}  // namespace

ScenarioBar::ScenarioBar(ProjectSession& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      scenario_(listOf("scenario", tr("The displayed scenario. Edits are added to it; on the existing city "
                                      "they start a new scenario"))),
      baseline_(listOf("baseline",
                       tr("Compare the scenario with this baseline: more or fewer minutes of shadow"))) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 0, 6, 0);
    row->addWidget(new QLabel(tr("Scenario")));
    row->addWidget(scenario_);
    row->addSpacing(8);
    row->addWidget(new QLabel(tr("compare with")));
    row->addWidget(baseline_);
    connect(scenario_, &QComboBox::activated, this,
            [this] { session_.goTo(scenario_->currentData().toString().toStdString()); });
    connect(baseline_, &QComboBox::activated, this,
            [this] { session_.compareWith(baseline_->currentData().toString().toStdString()); });
    connect(&session_, &ProjectSession::changed, this, &ScenarioBar::fill);
    fill();
}

void ScenarioBar::fill() {
    const QSignalBlocker blockScenario(*scenario_), blockBaseline(*baseline_);
    const std::vector<std::string> names = listNames(session_.project().scenarios);
    scenario_->clear();
    fillList(*scenario_, names, session_.scenario());
    baseline_->clear();
    baseline_->addItem(tr("nothing"), QString());
    std::vector<std::string> others = names;
    std::erase_if(others, [&](const std::string& name) {
        return name == session_.scenario() && name != session_.baseline();
    });
    fillList(*baseline_, others, session_.baseline());
}

}  // namespace noonmark
