#include "app/bench/chart_painter.h"

#include <QCategoryAxis>
#include <QChart>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QLegend>
#include <QLineSeries>
#include <optional>

#include "app/bench/axis_scale.h"
#include "app/bench/mark_painter.h"
#include "app/bench/point_labels.h"

namespace noonmark {

namespace {

/// Layout units of a chart: small enough for fonts of whole pixels, large enough for the paddings that Qt
/// Charts counts in pixels.
constexpr double unitsPerPoint = 4;

constexpr double titlePt = 8;
constexpr double axisPt = 6.6;
constexpr double markPt = 4.6;
constexpr double rightPt = 9;  // half the width of the last number of the axis below
constexpr double hairlinePt = 0.35;
constexpr double linePt = 1.1;

std::vector<double> getValues(const bench::Chart& chart, double bench::ChartPoint::*member) {
    std::vector<double> values;
    for (const auto& series : chart.series)
        for (const auto& point : series.points) values.push_back(point.*member);
    return values;
}

/// One chart as a QChart.
class QtChart {
public:
    QtChart(const Canvas& canvas, const QSizeF& size, const bench::Chart& chart, const ChartInks& inks)
        : canvas_{canvas.painter, unitsPerPoint},
          chart_(chart),
          inks_(inks),
          x_(chart.x, getValues(chart, &bench::ChartPoint::x)),
          y_(chart.y, getValues(chart, &bench::ChartPoint::y)),
          picture_(new QChart) {
        scene_.addItem(picture_);  // takes ownership
        dress();
        addAxis(x_, chart.x, Qt::AlignBottom);
        addAxis(y_, chart.y, Qt::AlignLeft);
        for (const auto& series : chart.series) addLine(series);
        picture_->resize(size);
        picture_->layout()->activate();
    }

    void paint(QPainter& painter, const QRectF& area) {
        scene_.render(&painter, area, picture_->geometry());
        const double scale = area.width() / picture_->size().width();
        painter.save();
        painter.translate(area.topLeft());
        painter.scale(scale, scale);
        paintMarks(painter);
        painter.restore();
    }

private:
    void dress() {
        picture_->setAnimationOptions(QChart::NoAnimation);
        picture_->legend()->hide();
        picture_->setBackgroundVisible(false);
        picture_->setMargins({0, 0, int(rightPt * unitsPerPoint), 0});
        picture_->layout()->setContentsMargins(0, 0, 0, 0);
        picture_->setTitle(QString::fromStdString(chart_.title));
        picture_->setTitleFont(textFont(canvas_, titlePt, QFont::Bold));
        picture_->setTitleBrush(ink::text);
    }

    void addAxis(const AxisScale& scale, const bench::ChartAxis& words, Qt::Alignment side) {
        auto* axis = new QCategoryAxis;
        axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
        axis->setStartValue(scale.low());
        for (const AxisTick& tick : scale.ticks()) axis->append(tick.text, tick.place);
        axis->setRange(scale.low(), scale.high());
        axis->setTitleText(QString::fromStdString(words.label));
        axis->setTitleFont(textFont(canvas_, axisPt));
        axis->setTitleBrush(ink::text);
        axis->setLabelsFont(textFont(canvas_, axisPt));
        axis->setLabelsBrush(ink::quiet);
        axis->setGridLinePen(linePen(canvas_, ink::line, hairlinePt));
        axis->setLinePen(linePen(canvas_, ink::quiet, hairlinePt * 1.5));
        axis->setTruncateLabels(false);
        picture_->addAxis(axis, side);
    }

    [[nodiscard]] std::optional<QPointF> placeOf(const bench::ChartPoint& point) const {
        if (!x_.shows(point.x) || !y_.shows(point.y)) return {};
        return QPointF(x_.placeOf(point.x), y_.placeOf(point.y));
    }

    void addLine(const bench::ChartSeries& series) {
        auto* line = new QLineSeries;
        for (const auto& point : series.points)
            if (const auto place = placeOf(point)) line->append(*place);
        QPen pen = linePen(canvas_, inks_.of(series.colourOf).colour, series.joined ? linePt : 0);
        if (series.estimated) pen.setDashPattern({4, 2.5});
        if (!series.joined) pen.setStyle(Qt::NoPen);
        line->setPen(pen);
        picture_->addSeries(line);
        for (QAbstractAxis* axis : picture_->axes()) line->attachAxis(axis);
        anyLine_ = line;
    }

    void paintMarks(QPainter& painter) {
        if (anyLine_ == nullptr) return;
        PointLabels labels({painter, unitsPerPoint}, picture_->plotArea(), markPt * unitsPerPoint);
        const auto each = [&](const auto& what) {
            for (const auto& series : chart_.series)
                for (const auto& point : series.points)
                    if (const auto place = placeOf(point); place && series.marked)
                        what(picture_->mapToPosition(*place, anyLine_), series, point);
        };
        each([&](const QPointF& at, const auto& series, const auto&) {
            paintMark(painter, at, inks_.of(series.colourOf), series.estimated, markPt * unitsPerPoint,
                      hairlinePt * 2 * unitsPerPoint);
            labels.addMark(at);
        });
        each([&](const QPointF& at, const auto& series, const auto& point) {
            labels.paint(at, QString::fromStdString(point.label), inks_.of(series.colourOf).colour);
        });
    }

    Canvas canvas_;
    const bench::Chart& chart_;
    const ChartInks& inks_;
    AxisScale x_;
    AxisScale y_;
    QGraphicsScene scene_;
    QChart* picture_;
    QLineSeries* anyLine_ = nullptr;  // owned by picture_
};

}  // namespace

void paintChart(const Canvas& canvas, const QRectF& area, const bench::Chart& chart, const ChartInks& inks) {
    const QSizeF size = area.size() * (unitsPerPoint / canvas.point);
    QtChart(canvas, size, chart, inks).paint(canvas.painter, area);
}

}  // namespace noonmark
