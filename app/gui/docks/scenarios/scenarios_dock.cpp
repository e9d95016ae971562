#include "app/gui/docks/scenarios/scenarios_dock.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/base/widgets/column_menu.h"
#include "app/gui/base/widgets/frozen_column.h"
#include "app/gui/base/widgets/push_button.h"
#include "app/gui/docks/scenarios/scenario_charts.h"
#include "app/gui/docks/scenarios/scenario_table.h"
#include "app/gui/session/project/project_session.h"

namespace noonmark {

namespace {

QWidget* rowOf(std::initializer_list<QWidget*> widgets) {
    auto* whole = new QWidget;
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 0, 0);
    for (QWidget* widget : widgets) row->addWidget(widget);
    return whole;
}

// Remembered in the settings under its name.
QCheckBox* switchOf(const QString& text, const char* name, QSettings& settings, const QString& tip) {
    const QString key = QString::fromLatin1(name);
    auto* box = new QCheckBox(text);
    box->setObjectName(key);
    box->setToolTip(tip);
    box->setChecked(settings.value(key).toBool());
    QObject::connect(box, &QCheckBox::toggled, box,
                     [&settings, key](bool on) { settings.setValue(key, on); });
    return box;
}

}  // namespace

ScenariosDock::ScenariosDock(ProjectSession& session, QSettings& settings, QWidget* parent)
    : QWidget(parent), table_(new ScenarioTable(session, this)), sorted_(new QSortFilterProxyModel(this)) {
    QTableView* view = makeView(settings);
    auto* hint = new QLabel(
        tr("Only the existing city so far. Select a building and change it, or design a tower on a lot: the "
           "first change begins a scenario, which is listed here."));
    hint->setObjectName(QStringLiteral("scenariosHint"));
    hint->setWordWrap(true);
    const auto follow = [hint, &session] { hint->setVisible(session.project().scenarios.empty()); };
    connect(&session, &ProjectSession::changed, hint, follow);
    follow();
    auto* verdict = new QLabel;
    verdict->setObjectName(QStringLiteral("scenarioVerdict"));
    verdict->setWordWrap(true);
    verdict->setTextInteractionFlags(Qt::TextSelectableByMouse);
    const auto judge = [this, verdict] {
        verdict->setText(table_->verdict());
        verdict->setVisible(!verdict->text().isEmpty());
    };
    connect(table_, &QAbstractItemModel::dataChanged, verdict, judge);
    connect(table_, &QAbstractItemModel::modelReset, verdict, judge);
    judge();
    auto* charts = new ScenarioCharts(*table_, settings);
    connect(charts, &ScenarioCharts::exportRequested, this, &ScenariosDock::monthsExportRequested);
    auto* column = new QVBoxLayout(this);
    column->addWidget(verdict);
    column->addWidget(view, 1);
    column->addWidget(makeSwitches(settings));
    column->addWidget(hint);
    column->addWidget(makeButtons());
    column->addWidget(charts, 1);
    connect(view, &QTableView::doubleClicked, this, [this, &session](const QModelIndex& index) {
        session.goTo(table_->scenarioAt(sorted_->mapToSource(index).row()));
    });
}

QWidget* ScenariosDock::makeButtons() {
    auto* measure =
        pushButton(tr("Measure all"), "measureAll",
                   tr("Runs the study for scenarios without figures, with the current period and region"));
    auto* score = pushButton(tr("Score all"), "scoreAll",
                             tr("Computes the missing scores with the table that the dock Weights shows"));
    auto* review = pushButton(tr("Review all"), "reviewAll",
                              tr("Reviews the scenarios without verdicts by the rule, the baseline and the "
                                 "places that are chosen in the dock Review"));
    connect(measure, &QPushButton::clicked, this, &ScenariosDock::measureAllRequested);
    connect(score, &QPushButton::clicked, this, &ScenariosDock::scoreAllRequested);
    connect(review, &QPushButton::clicked, this, &ScenariosDock::reviewAllRequested);
    return rowOf({measure, score, review});
}

// How figures are shown, and what is done with the table.
QWidget* ScenariosDock::makeSwitches(QSettings& settings) {
    auto* differences = switchOf(tr("Differences"), "scenarioDifferences", settings,
                                 tr("Shows figures as differences to the baseline: the chosen one, else the "
                                    "existing city"));
    auto* shade =
        switchOf(tr("Shade is wanted"), "shadeWanted", settings,
                 tr("The star marks the scenario with most shadow as the best, not that with least"));
    auto* copy = pushButton(tr("Copy"), "copyScenarios", tr("Copies the table for a spreadsheet"));
    auto* save = pushButton(tr("CSV…"), "exportScenarios",
                            tr("Saves the table with what each scenario lacks, in metres and square metres"));
    connect(differences, &QCheckBox::toggled, table_, &ScenarioTable::setDifferences);
    connect(shade, &QCheckBox::toggled, table_, &ScenarioTable::setShadeWanted);
    table_->setDifferences(differences->isChecked());
    table_->setShadeWanted(shade->isChecked());
    connect(copy, &QPushButton::clicked, this, &ScenariosDock::copyRequested);
    connect(save, &QPushButton::clicked, this, &ScenariosDock::exportRequested);
    auto* switches = new QWidget;
    auto* column = new QVBoxLayout(switches);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(rowOf({differences, shade}));
    column->addWidget(rowOf({copy, save}));
    return switches;
}

const QAbstractItemModel& ScenariosDock::shownTable() const { return *sorted_; }

// In the project's order until a heading is clicked, and again after its third click.
QTableView* ScenariosDock::makeView(QSettings& settings) {
    sorted_->setSourceModel(table_);
    sorted_->setSortRole(ScenarioTable::sortRole);
    sorted_->setSortLocaleAware(true);
    auto* view = new QTableView;
    view->setObjectName(QStringLiteral("scenarioTable"));
    view->setModel(sorted_);
    view->setSelectionBehavior(QAbstractItemView::SelectRows);
    view->setShowGrid(false);
    view->verticalHeader()->hide();
    QHeaderView* heading = view->horizontalHeader();
    heading->setSectionResizeMode(QHeaderView::ResizeToContents);
    view->setWordWrap(false);
    view->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    new ColumnMenu(*heading, ScenarioTable::keyRole, settings, QStringLiteral("hiddenScenarioColumns"));
    heading->setSortIndicatorClearable(true);
    heading->setSortIndicator(-1, Qt::AscendingOrder);
    view->setSortingEnabled(true);
    new FrozenColumn(*view);
    return view;
}

}  // namespace noonmark
