#include "app/gui/docks/scenarios/scenario_charts.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/base/widgets/number_words.h"
#include "app/gui/base/widgets/push_button.h"
#include "app/gui/base/widgets/translated.h"
#include "app/gui/docks/scenarios/scenario_table.h"
#include "app/gui/session/answers/bar_charts.h"
#include "app/report/maps/palette.h"
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
        if (textOf(name.key) == key && name.ofScore)
            return ScenarioCharts::tr("No scenario has been scored by month: press Score all");
    return ScenarioCharts::tr(
        "No scenario has months: tick Each month by itself in the dock Study, and press Measure all");
}

QString describeWhatLacks(const MonthChart& chart, std::size_t shown, const std::string& baseline) {
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
        const QString note = describeWhatLacks(chart, maxSeries, months.front().name);
        if (!note.isEmpty() && !notes.contains(note)) notes << note;
    }
    if (drawn.empty()) notes << describeMissing(key);
    showCharts(!drawn.empty());
    charts_->show(drawn);
    note_->setText(notes.join(QLatin1Char('\n')));
    note_->setVisible(!notes.empty());
}

}  // namespace noonmark
