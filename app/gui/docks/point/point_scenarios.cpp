#include "app/gui/docks/point/point_scenarios.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/base/widgets/number_words.h"
#include "app/gui/docks/point/point_inspector.h"

namespace noonmark {

namespace {

enum Column { scenarioColumn, dayColumn, yearColumn, changeColumn, skyColumn, componentColumn, columnCount };

QComboBox* scenarioList(const char* name, const QString& tip) {
    auto* list = new QComboBox;
    list->setObjectName(QString::fromLatin1(name));
    list->setToolTip(tip);
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(10);
    return list;
}

void fillScenarios(QComboBox& list, const QString& usual, const QStringList& names, const std::string& now) {
    const QSignalBlocker quiet(list);
    list.clear();
    list.addItem(usual);
    list.addItems(names);
    const qsizetype chosen = now.empty() ? -1 : names.indexOf(QString::fromStdString(now));
    list.setCurrentIndex(int(chosen) + 1);
}

std::string chosenIn(const QComboBox& list) {
    return list.currentIndex() <= 0 ? std::string() : list.currentText().toStdString();
}

QStringList textsOf(const PointCaseFigures& figures, double firstYearMin, bool wall) {
    const double change = (figures.yearMin - firstYearMin) / 60;
    return {QString::fromStdString(figures.name),
            groupDigits(figures.dayMin, 0),
            groupDigits(figures.yearMin / 60, 0),
            (change > 0 ? QStringLiteral("+") : QString()) + groupDigits(change, 1),
            groupDigits(figures.skyView, 3),
            wall ? groupDigits(figures.skyComponentPct, 1) : QString()};
}

}  // namespace

PointScenarios::PointScenarios(PointInspector& inspector, QWidget* parent)
    : QWidget(parent), inspector_(inspector) {
    makeFields();
    connect(from_, &QComboBox::activated, this, &PointScenarios::choose);
    connect(to_, &QComboBox::activated, this, &PointScenarios::choose);
    connect(&inspector_, &PointInspector::scenariosChanged, this, &PointScenarios::fillLists);
    connect(&inspector_, &PointInspector::changed, this, &PointScenarios::showTable);
    fillLists();
    showTable();
}

void PointScenarios::makeFields() {
    from_ = scenarioList("pointFrom", tr("The scenario before: what the other one is compared with"));
    to_ = scenarioList("pointTo", tr("The scenario whose sun at the point is compared"));
    table_ = new QTableWidget(0, columnCount);
    table_->setObjectName(QStringLiteral("pointScenarios"));
    table_->setToolTip(
        tr("The point's sun and sky in every scenario of the project. Copy (Ctrl+C) takes the "
           "table"));
    table_->setHorizontalHeaderLabels(
        {tr("Scenario"), tr("Day, min"), tr("Year, h"), tr("Change, h"), tr("Sky view"), tr("VSC, %")});
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    auto* lists = new QFormLayout;
    lists->setContentsMargins(0, 0, 0, 0);
    lists->addRow(tr("Before"), from_);
    lists->addRow(tr("After"), to_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(lists);
    column->addWidget(table_);
}

void PointScenarios::fillLists() {
    const QStringList names = inspector_.scenarios();
    fillScenarios(*from_, tr("the baseline"), names, inspector_.comparison().from);
    fillScenarios(*to_, tr("the displayed scenario"), names, inspector_.comparison().to);
    setVisible(names.size() > 1);
}

void PointScenarios::choose() { inspector_.compare({chosenIn(*from_), chosenIn(*to_)}); }

void PointScenarios::showTable() {
    const auto answer = inspector_.answer();
    const std::vector<PointCaseFigures> cases = answer ? answer->cases : std::vector<PointCaseFigures>();
    table_->setVisible(!cases.empty());
    table_->clearSpans();
    table_->setRowCount(int(cases.size()));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const bool measured = cases[i].why.empty();
        const QStringList texts =
            measured
                ? textsOf(cases[i], cases.front().yearMin, answer->study.question.facingDeg.has_value())
                : QStringList{QString::fromStdString(cases[i].name), QString::fromStdString(cases[i].why)};
        for (int column = 0; column < columnCount; ++column) {
            auto* item = new QTableWidgetItem(texts.value(column));
            if (measured && column > scenarioColumn)
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table_->setItem(int(i), column, item);
        }
        if (!measured) table_->setSpan(int(i), dayColumn, 1, columnCount - 1);
    }
    table_->resizeColumnsToContents();
    const int rows = table_->verticalHeader()->defaultSectionSize() * std::min(8, table_->rowCount());
    table_->setFixedHeight(rows + table_->horizontalHeader()->sizeHint().height() + 20);
}

}  // namespace noonmark
