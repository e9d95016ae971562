#include "app/gui/docks/scenarios/scenarios_dock.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/base/widgets/column_menu.h"
#include "app/gui/base/widgets/push_button.h"
#include "app/gui/docks/scenarios/scenario_table.h"
#include "app/gui/session/project/project_session.h"

namespace noonmark {

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
    auto* column = new QVBoxLayout(this);
    column->addWidget(view);
    column->addWidget(hint);
    column->addWidget(makeButtons());
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
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    for (QPushButton* button : {measure, score, review}) row->addWidget(button);
    return buttons;
}

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
    return view;
}

}  // namespace noonmark
