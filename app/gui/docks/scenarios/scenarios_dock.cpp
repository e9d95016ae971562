#include "app/gui/docks/scenarios/scenarios_dock.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/base/widgets/table_columns.h"
#include "app/gui/docks/scenarios/scenario_table.h"
#include "app/gui/session/answers/bar_charts.h"
#include "app/gui/session/project/project_session.h"
#include "app/report/maps/style.h"
#include "app/report/scenarios/scenario_months.h"

namespace noonmark {

namespace {

constexpr int chartsPx = 190;  // at least: one chart
constexpr const char* chosenKey = "scenarioChart";
constexpr const char* allKey = "all";

QString textOf(std::string_view key) { return QString::fromUtf8(key.data(), qsizetype(key.size())); }

// Why no scenario has the figure.
QString describeMissing(const QString& key) {
    for (const MonthChartName& name : monthChartNames())
        if (textOf(name.key) == key && name.of != MonthsOf::study)
            return name.of == MonthsOf::score
                       ? ScenarioCharts::tr("No scenario has been scored by month: press Score all")
                       : ScenarioCharts::tr(
                             "No places have been measured: choose Sun by place in the panel "
                             "Study, and press Measure all");
    return ScenarioCharts::tr("No scenario has months yet. %1")
        .arg(QStringLiteral("<a href=\"months\">%1</a>").arg(ScenarioCharts::tr("Measure all by month")));
}

QString describeMissingFigures(const MonthChart& chart, std::size_t shown, const std::string& baseline) {
    QStringList lines;
    const std::size_t all = chart.values.series.size();
    if (all > shown)
        lines << ScenarioCharts::tr("The first %1 of %2 scenarios; CSV saves all of them")
                     .arg(formatCount(shown), formatCount(all));
    if (all > 0 && chart.values.series.front() != baseline)
        lines << ScenarioCharts::tr("No differences: the baseline %1 lacks this figure")
                     .arg(QString::fromStdString(baseline));
    return lines.join(QLatin1Char('\n'));
}

}  // namespace

ScenarioCharts::ScenarioCharts(const ScenarioTable& table, QSettings& settings, QWidget* parent)
    : QWidget(parent),
      table_(table),
      figure_(new QComboBox),
      save_(pushButton(tr("CSV…"), "exportMonths",
                       tr("Saves all figures of the months of all scenarios, with their differences to the "
                          "baseline"))),
      note_(new QLabel),
      charts_(new BarCharts),
      scroll_(new QScrollArea),
      later_(new QTimer(this)) {
    fillList(settings.value(QLatin1String(chosenKey)).toString());
    placeFields();
    later_->setSingleShot(true);
    later_->setInterval(0);
    connect(later_, &QTimer::timeout, this, &ScenarioCharts::draw);
    connect(save_, &QPushButton::clicked, this, &ScenarioCharts::exportRequested);
    connect(note_, &QLabel::linkActivated, this, &ScenarioCharts::monthsRequested);
    connect(figure_, &QComboBox::currentIndexChanged, this, [this, &settings] {
        settings.setValue(QLatin1String(chosenKey), figure_->currentData());
        draw();
    });
    connect(&table, &QAbstractItemModel::dataChanged, this, &ScenarioCharts::follow);
    connect(&table, &QAbstractItemModel::modelReset, this, &ScenarioCharts::follow);
    draw();
}

void ScenarioCharts::fillList(const QString& chosen) {
    figure_->setObjectName(QStringLiteral("scenarioChart"));
    figure_->setToolTip(
        tr("A chart of the months of all scenarios, and of their differences to the baseline"));
    figure_->addItem(tr("No chart"), QString());
    for (const MonthChartName& name : monthChartNames())
        figure_->addItem(translated(name.title), textOf(name.key));
    figure_->addItem(tr("All of these together"), QString::fromLatin1(allKey));
    figure_->setCurrentIndex(std::max(0, figure_->findData(chosen)));
    figure_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    figure_->setMinimumContentsLength(12);
}

void ScenarioCharts::placeFields() {
    note_->setObjectName(QStringLiteral("scenarioChartNote"));
    note_->setWordWrap(true);
    scroll_->setWidget(charts_);
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setMinimumHeight(chartsPx);
    auto* row = new QHBoxLayout;
    row->addWidget(figure_, 1);
    row->addWidget(save_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addWidget(note_);
    column->addWidget(scroll_, 1);
}

void ScenarioCharts::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    draw();
}

// Without charts, the table gets their room.
void ScenarioCharts::showCharts(bool shown) {
    scroll_->setVisible(shown);
    setSizePolicy(QSizePolicy::Preferred, shown ? QSizePolicy::Expanding : QSizePolicy::Maximum);
}

void ScenarioCharts::follow() {
    if (isVisible()) later_->start();
}

// Months are summed over all cells, which takes some ms a scenario: only for a chart that is wanted.
void ScenarioCharts::draw() {
    const QString key = figure_->currentData().toString();
    showCharts(!key.isEmpty());
    note_->setVisible(!key.isEmpty());
    save_->setVisible(!key.isEmpty());
    if (key.isEmpty()) return charts_->show({});
    const std::vector<ScenarioMonths> months = table_.months();
    const std::vector<MonthChart> charts = makeMonthCharts(months);
    save_->setEnabled(!charts.empty());
    std::vector<Bars> drawn;
    QStringList notes;
    for (const MonthChart& chart : charts) {
        if (key != QLatin1String(allKey) && textOf(chart.key) != key) continue;
        drawn.push_back(firstSeries(chart.values, maxSeries));
        drawn.push_back(firstSeries(chart.changes, maxSeries - 1));
        const QString note = describeMissingFigures(chart, maxSeries, months.front().name);
        if (!note.isEmpty() && !notes.contains(note)) notes << note;
    }
    if (drawn.empty()) notes << describeMissing(key);
    showCharts(!drawn.empty());
    charts_->show(drawn);
    note_->setText(notes.join(QLatin1Char('\n')));
    note_->setVisible(!notes.empty());
}

namespace {

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
    : QWidget(parent),
      table_(new ScenarioTable(session, this)),
      progress_(new ProgressStrip(QBoxLayout::TopToBottom)),
      sorted_(new QSortFilterProxyModel(this)) {
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
    connect(charts, &ScenarioCharts::monthsRequested, this, &ScenariosDock::measureMonthsRequested);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    column->addWidget(verdict);
    column->addWidget(view, 1);
    column->addWidget(makeSwitches(settings));
    column->addWidget(hint);
    column->addWidget(makeButtons());
    column->addWidget(progress_);
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
                             tr("Computes the missing scores with the table that the panel Weights shows"));
    auto* review = pushButton(tr("Review all"), "reviewAll",
                              tr("Reviews the scenarios without verdicts by the rule, the baseline and the "
                                 "places that are chosen in the panel Review"));
    connect(measure, &QPushButton::clicked, this, &ScenariosDock::measureAllRequested);
    connect(score, &QPushButton::clicked, this, &ScenariosDock::scoreAllRequested);
    connect(review, &QPushButton::clicked, this, &ScenariosDock::reviewAllRequested);
    return widgetRow({measure, score, review});
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
    column->addWidget(widgetRow({differences, shade}));
    column->addWidget(widgetRow({copy, save}));
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
    const auto order = [this, heading] {
        const std::vector<int> columns = table_->readingOrder();
        for (int at = 0; at < int(columns.size()); ++at)
            heading->moveSection(heading->visualIndex(columns[std::size_t(at)]), at);
    };
    connect(table_, &QAbstractItemModel::dataChanged, heading, order);
    connect(table_, &QAbstractItemModel::modelReset, heading, order);
    order();
    return view;
}

}  // namespace noonmark
