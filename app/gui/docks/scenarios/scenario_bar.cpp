#include "app/gui/docks/scenarios/scenario_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

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

void fillList(QComboBox& list, const QStringList& names, const QString& now) {
    const QSignalBlocker block(list);
    list.clear();
    list.addItems(names);
    list.setCurrentIndex(int(std::max<qsizetype>(0, names.indexOf(now))));
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
            [this] { session_.goTo(scenario_->currentText().toStdString()); });
    connect(baseline_, &QComboBox::activated, this, [this](int chosen) {
        session_.compareWith(chosen == 0 ? std::string() : baseline_->currentText().toStdString());
    });
    connect(&session_, &ProjectSession::changed, this, &ScenarioBar::fill);
    fill();
}

void ScenarioBar::fill() {
    QStringList names{QString::fromLatin1(existingCity)};
    for (const Scenario& scenario : session_.project().scenarios)
        names << QString::fromStdString(scenario.name);
    fillList(*scenario_, names, QString::fromStdString(session_.scenario()));
    names.prepend(tr("nothing"));
    fillList(*baseline_, names, QString::fromStdString(session_.baseline()));
}

}  // namespace noonmark
