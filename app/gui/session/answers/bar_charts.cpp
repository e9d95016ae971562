#include "app/gui/session/answers/bar_charts.h"

#include <QAction>
#include <QBarCategoryAxis>
#include <QBarSeries>
#include <QBarSet>
#include <QChart>
#include <QChartView>
#include <QClipboard>
#include <QFontMetrics>
#include <QGraphicsLayout>
#include <QGuiApplication>
#include <QLegend>
#include <QLocale>
#include <QStackedBarSeries>
#include <QToolTip>
#include <QVBoxLayout>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/report/maps/style.h"

namespace noonmark {

namespace {

constexpr int chartHeightPx = 170;
constexpr int maxNamePx = 80;
constexpr int monthNamePx = 50;  // has room in a chart of this height
constexpr int letterPx = 10;
constexpr int marginPx = 4;
constexpr int nameBorderPx = 8;  // that the axis adds to its names, and does not make room for

QFont smallFont(QFont font, bool bold = false) {
    font.setPixelSize(letterPx);
    font.setBold(bold);
    return font;
}

// "−45 to −40" where the numbers have signs, which a dash would hide; else "2–4".
QString nameOf(const Bars::Class& values, bool isSigned) {
    const auto text = [](double value) {
        return (value < 0 ? QStringLiteral("−") : QString()) + formatAmount(std::abs(value), 2);
    };
    return isSigned ? QObject::tr("%1 to %2").arg(text(values.low), text(values.high))
                    : QStringLiteral("%1–%2").arg(text(values.low), text(values.high));
}

bool hasNegative(const Bars& bars) {
    return std::ranges::any_of(bars.groups, [](const Bars::Group& group) {
        const auto* values = std::get_if<Bars::Class>(&group.name);
        return values != nullptr && values->low < 0;
    });
}

QString nameOf(const Bars& bars, const Bars::Group& group) {
    if (const auto* values = std::get_if<Bars::Class>(&group.name)) return nameOf(*values, hasNegative(bars));
    if (const auto* month = std::get_if<std::chrono::year_month>(&group.name)) return describeMonth(*month);
    return localiseNumbers(QString::fromStdString(std::get<std::string>(group.name)));
}

// Below the axis: long names are cut, and equal ones told apart by marks without width, since the axis takes
// each name once only.
QStringList namesOf(const Bars& bars, const QFont& font) {
    const QFontMetrics metrics(smallFont(font));
    QStringList names;
    for (const Bars::Group& group : bars.groups) {
        QString name = metrics.elidedText(nameOf(bars, group), Qt::ElideMiddle, maxNamePx);
        while (names.contains(name)) name += QChar(0x200b);
        names << name;
    }
    return names;
}

QColor colourOf(BarTone tone) {
    if (tone == BarTone::amount) return shadowColour(0.6);
    if (tone == BarTone::sun) return shade::sun;
    return impactColour(tone == BarTone::gain ? -0.8 : 0.8);
}

// "Jun 2026: 1,204.5"
QString describeBar(const Bars& bars, int group, std::size_t series) {
    const Bars::Group& of = bars.groups[std::size_t(group)];
    const double amount = of.values[series];
    const QString number = formatAmount(amount, std::abs(amount) < 100 ? 2 : 0);
    const QString value = bars.isChange ? withPlus(amount, number) : number;
    QString text = QObject::tr("%1: %2").arg(nameOf(bars, of), value);
    if (!bars.series[series].empty())
        text = QString::fromStdString(bars.series[series]) + QStringLiteral(", ") + text;
    return text;
}

QBarSet* setOf(const Bars& bars, std::size_t series, const QColor& colour) {
    auto* set = new QBarSet(QString::fromStdString(bars.series[series]));
    set->setColor(colour);
    set->setBorderColor(Qt::transparent);
    QObject::connect(set, &QBarSet::hovered, set, [bars, series](bool above, int group) {
        if (above && group >= 0 && group < int(bars.groups.size()))
            QToolTip::showText(QCursor::pos(), describeBar(bars, group, series));
        else
            QToolTip::hideText();
    });
    return set;
}

// The series have colours of their own, and a legend.
bool isNamed(const Bars& bars) { return bars.series.size() > 1 || bars.isChange; }

double heightOf(double value) { return std::isnan(value) ? 0 : value; }

// A set for each tone: those of the others are empty, and stand on one another.
QAbstractBarSeries* tonedSeries(const Bars& bars) {
    auto* series = new QStackedBarSeries;
    for (const BarTone tone : {BarTone::amount, BarTone::sun, BarTone::gain, BarTone::loss}) {
        QBarSet* set = setOf(bars, 0, colourOf(tone));
        for (const Bars::Group& group : bars.groups)
            *set << (group.tone == tone ? heightOf(group.values.front()) : 0.0);
        series->append(set);
    }
    return series;
}

QAbstractBarSeries* seriesOf(const Bars& bars) {
    if (!isNamed(bars)) return tonedSeries(bars);
    auto* all = new QBarSeries;
    for (std::size_t i = 0; i < bars.series.size(); ++i) {
        QBarSet* set = setOf(bars, i, seriesColour(bars.isChange ? i + 1 : i));
        for (const Bars::Group& group : bars.groups) *set << heightOf(group.values[i]);
        all->append(set);
    }
    return all;
}

template <class Axis>
Axis* axisOf(const QFont& font) {
    const Inks inks = inksOf(themeInUse());
    auto* axis = new Axis;
    axis->setLabelsFont(smallFont(font));
    axis->setLabelsBrush(inks.quiet);
    axis->setGridLinePen(QPen(inks.line, 0.5));
    axis->setLinePen(QPen(inks.quiet, 0.5));
    return axis;
}

void addAxes(QChart& chart, QAbstractBarSeries& series, const Bars& bars, const QFont& font) {
    auto* groups = axisOf<QBarCategoryAxis>(font);
    groups->append(namesOf(bars, font));
    groups->setLabelsAngle(-90);
    groups->setTruncateLabels(false);
    groups->setGridLineVisible(false);
    auto* amount = axisOf<QValueAxis>(font);
    chart.addAxis(groups, Qt::AlignBottom);
    chart.addAxis(amount, Qt::AlignLeft);
    series.attachAxis(groups);
    series.attachAxis(amount);
    if (amount->min() < amount->max())
        amount->applyNiceNumbers();
    else
        amount->setRange(0, 1);  // all values are 0: an empty range would give no tick labels
    amount->setLabelFormat(amount->max() - amount->min() < 10 ? QStringLiteral("%g")
                                                              : QStringLiteral("%.0f"));
}

// The axis leaves room for names as long as the first. Those of October to December are longer in some
// languages and lost their tens.
int roomForLongerNames(const QStringList& names, const QFont& font) {
    const QFontMetrics metrics(smallFont(font));
    const auto widthOf = [&](const QString& name) { return metrics.horizontalAdvance(name); };
    const auto [minimum, maximum] = std::ranges::minmax(names, {}, widthOf);
    return widthOf(maximum) - widthOf(minimum) + marginPx + nameBorderPx;
}

// What the groups are stands below the title: as the title of their axis it would lie on the longest names.
QString titleOf(const Bars& bars) {
    const QString title = translated(bars.title).toHtmlEscaped();
    if (bars.groupName.empty()) return title;
    return QStringLiteral("%1<br><span style='font-weight:normal'>%2</span>")
        .arg(title, translated(bars.groupName).toHtmlEscaped());
}

// For spreadsheets: a row for each group, with tabs.
QString tableText(const Bars& bars) {
    QString text = bars.groupName.empty() ? QString() : translated(bars.groupName);
    for (const std::string& name : bars.series) text += u'\t' + QString::fromStdString(name);
    for (const Bars::Group& group : bars.groups) {
        text += u'\n' + nameOf(bars, group);
        for (const double value : group.values)
            text += u'\t' + (std::isnan(value) ? QString() : QLocale().toString(value, 'g', 10));
    }
    return text + u'\n';
}

int longestOf(const QStringList& names, const QFont& font) {
    const QFontMetrics metrics(smallFont(font));
    int longest = 0;
    for (const QString& name : names) longest = std::max(longest, metrics.horizontalAdvance(name));
    return longest;
}

QChartView* viewOf(const Bars& bars, const QFont& font) {
    const Inks inks = inksOf(themeInUse());
    const QStringList names = namesOf(bars, font);
    auto* chart = new QChart;
    chart->setAnimationOptions(QChart::NoAnimation);
    chart->legend()->setVisible(isNamed(bars));
    chart->legend()->setFont(smallFont(font));
    chart->legend()->setLabelColor(inks.text);
    chart->setTitle(titleOf(bars));
    chart->setTitleFont(smallFont(font, true));
    chart->setTitleBrush(inks.text);
    chart->setBackgroundBrush(inks.paper);
    chart->setMargins({0, 0, marginPx, roomForLongerNames(names, font)});
    chart->layout()->setContentsMargins(0, 0, 0, 0);
    QAbstractBarSeries* series = seriesOf(bars);
    series->setBarWidth(0.8);
    chart->addSeries(series);
    addAxes(*chart, *series, bars, font);
    auto* view = new QChartView(chart);  // owns the chart
    view->setRenderHint(QPainter::Antialiasing);
    view->setFixedHeight(chartHeightPx + nameBorderPx +
                         2 * std::max(0, longestOf(names, font) - monthNamePx));
    view->setFrameShape(QFrame::NoFrame);
    view->setContextMenuPolicy(Qt::ActionsContextMenu);
    auto* copy = new QAction(QObject::tr("&Copy the values"), view);
    QObject::connect(copy, &QAction::triggered, view,
                     [bars] { QGuiApplication::clipboard()->setText(tableText(bars)); });
    view->addAction(copy);
    return view;
}

}  // namespace

BarCharts::BarCharts(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    hide();
    followTheme(*this, [this] { show(charts_); });
}

void BarCharts::show(const std::vector<Bars>& charts) {
    charts_ = charts;
    std::erase_if(charts_, [](const Bars& bars) { return bars.groups.empty(); });
    while (QLayoutItem* item = layout()->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    setVisible(!charts_.empty());
    for (const Bars& bars : charts_) layout()->addWidget(viewOf(bars, font()));
}

}  // namespace noonmark
