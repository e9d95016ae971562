#include "app/window/scenarios/scenarios_dock.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

#include "app/window/project/project_session.h"
#include "app/window/scenarios/scenario_table.h"

namespace noonmark {

ScenariosDock::ScenariosDock(ProjectSession& session, QWidget* parent)
    : QWidget(parent), table_(new ScenarioTable(session, this)), sorted_(new QSortFilterProxyModel(this)) {
    QTableView* view = makeView();
    auto* hint = new QLabel(
        tr("Only the existing city so far. Select a building and change it, or design a tower on a lot: the "
           "first change begins a scenario, which is listed here."));
    hint->setObjectName(QStringLiteral("scenariosHint"));
    hint->setWordWrap(true);
    const auto follow = [hint, &session] { hint->setVisible(session.project().scenarios.empty()); };
    connect(&session, &ProjectSession::changed, hint, follow);
    follow();
    auto* measure = new QPushButton(tr("Measure all"));
    measure->setToolTip(
        tr("Runs the study for scenarios without figures, with the current period and region"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(view);
    column->addWidget(hint);
    column->addWidget(measure);
    connect(measure, &QPushButton::clicked, this, &ScenariosDock::measureAllRequested);
    connect(view, &QTableView::doubleClicked, this, [this, &session](const QModelIndex& index) {
        session.goTo(table_->scenarioAt(sorted_->mapToSource(index).row()));
    });
}

// In the project's order until a heading is clicked, and again after its third click.
QTableView* ScenariosDock::makeView() {
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
    heading->setSectionResizeMode(0, QHeaderView::Stretch);
    heading->setSortIndicatorClearable(true);
    heading->setSortIndicator(-1, Qt::AscendingOrder);
    view->setSortingEnabled(true);
    return view;
}

}  // namespace noonmark
