#include "app/bench/chart_painter.h"

#include <QCategoryAxis>
#include <QChart>
#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QLegend>
#include <QLineSeries>
#include <QPolygonF>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace noonmark {

namespace {

/// Labels beside points. Labels do not overlap each other or a mark; a label without room is dropped.
class PointLabels {
public:
    /// `within`: the area for labels; `markSize` in painter units.
    PointLabels(const Canvas& canvas, const QRectF& within, double markSize);

    /// Registers the position of a mark. Add all marks before painting labels.
    void addMark(const QPointF& at);
    void paint(const QPointF& at, const QString& text, const QColor& colour);

private:
    [[nodiscard]] bool isFree(const QRectF& box) const;

    Canvas canvas_;
    QRectF within_;
    double markSize_;
    std::vector<QRectF> taken_;
};

constexpr double labelPt = 5.8;

PointLabels::PointLabels(const Canvas& canvas, const QRectF& within, double markSize)
    : canvas_(canvas), within_(within), markSize_(markSize) {}

void PointLabels::addMark(const QPointF& at) {
    const double half = 0.6 * markSize_;
    taken_.emplace_back(at - QPointF(half, half), QSizeF(2 * half, 2 * half));
}

void PointLabels::paint(const QPointF& at, const QString& text, const QColor& colour) {
    if (text.isEmpty()) return;
    QPainter& painter = canvas_.painter;
    painter.setFont(textFont(canvas_, labelPt));
    const QFontMetricsF metrics(painter.font());
    const QSizeF size(metrics.horizontalAdvance(text), metrics.ascent());
    const double gap = 0.75 * markSize_;
    const double middle = at.y() - size.height() / 2, centre = at.x() - size.width() / 2;
    const std::array places{QPointF(at.x() + gap, middle), QPointF(at.x() - gap - size.width(), middle),
                            QPointF(centre, at.y() - gap - size.height()), QPointF(centre, at.y() + gap)};
    for (const QPointF& place : places) {
        const QRectF box(place, size);
        if (!isFree(box)) continue;
        taken_.push_back(box);
        painter.fillRect(box, ink::paper);  // no line crosses a label
        painter.setPen(colour);
        painter.drawText(QPointF(box.left(), box.bottom() - 0.12 * size.height()), text);
        return;
    }
}

bool PointLabels::isFree(const QRectF& box) const {
    return within_.contains(box) &&
           std::ranges::none_of(taken_, [&](const QRectF& other) { return other.intersects(box); });
}

constexpr double maxTicks = 6;
constexpr double edge = 0.06;  // share of the span of a logarithmic axis left free at each end

QString powerText(int exponent) {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = exponent < 0 ? QStringLiteral("10⁻") : QStringLiteral("10");
    for (const QChar digit : QString::number(std::abs(exponent))) text += digits[digit.digitValue()];
    return text;
}

QString numberText(double value) {
    const double exponent = std::log10(std::abs(value));
    const bool isPower = std::abs(exponent - std::round(exponent)) < 1e-9;
    if (value != 0 && isPower && std::abs(exponent) > 3.5) return powerText(int(std::lround(exponent)));
    return QString::number(value, 'g', 6);
}

/// 1, 2 or 5 times a power of ten, such that at most `maxTicks` steps fill the span.
double roundStep(double span) {
    double step = std::pow(10, std::floor(std::log10(span / maxTicks)));
    for (const double factor : {2.0, 2.5, 2.0})
        if (span / step > maxTicks) step *= factor;
    return step;
}

/// The multiples within a decade that get a tick.
std::vector<double> marksOfDecade(double decades) {
    if (decades > 2.2) return {1};
    if (decades > 1.2) return {1, 3};
    return {1, 2, 5};
}

}  // namespace

AxisScale::AxisScale(const bench::ChartAxis& axis, const std::vector<double>& values) : axis_(axis) {
    double minimum = INFINITY, maximum = -INFINITY;
    for (const double value : values) {
        if (!shows(value)) continue;
        minimum = std::min(minimum, value);
        maximum = std::max(maximum, value);
    }
    if (minimum > maximum) minimum = maximum = 1;
    axis.logarithmic ? setLogarithmic(minimum, maximum) : setLinear(minimum, maximum);
}

double AxisScale::placeOf(double value) const { return axis_.logarithmic ? std::log10(value) : value; }

bool AxisScale::shows(double value) const {
    return std::isfinite(value) && (!axis_.logarithmic || value > 0);
}

void AxisScale::setLinear(double minimum, double maximum) {
    if (axis_.fromZero) minimum = std::min(minimum, 0.0);
    if (maximum - minimum < 1e-12) maximum = minimum + 1;
    const double step = std::max(roundStep(maximum - minimum), axis_.whole ? 1.0 : 0.0), slack = 1e-9 * step;
    low_ = std::floor((minimum + slack) / step) * step;
    high_ = std::ceil((maximum - slack) / step) * step;
    for (double value = low_; value < high_ + step / 2; value += step)
        ticks_.push_back({value, numberText(std::abs(value) < step / 2 ? 0 : value)});
}

void AxisScale::setLogarithmic(double minimum, double maximum) {
    const double decades = std::max(0.3, std::log10(maximum / minimum));
    low_ = std::log10(minimum) - edge * decades;
    high_ = std::max(std::log10(maximum), std::log10(minimum) + decades) + edge * decades;
    const int every = std::max(1, int(std::ceil(decades / maxTicks)));
    for (int decade = int(std::floor(low_)); decade <= int(std::ceil(high_)); ++decade)
        for (const double factor : marksOfDecade(decades)) {
            const double place = decade + std::log10(factor);
            if (decade % every == 0 && place >= low_ && place <= high_)
                ticks_.push_back({place, numberText(factor * std::pow(10, decade))});
        }
}

namespace {

// A regular polygon with a corner at the top if `turn` is 0; `turn` is a share of the full circle.
QPainterPath polygonPath(int corners, double radius, double turn = 0) {
    QPolygonF polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * (double(i) / corners + turn);
        polygon << QPointF(radius * std::sin(angle), -radius * std::cos(angle));
    }
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    return path;
}

}  // namespace

QPainterPath markPath(MarkShape shape, double size) {
    const double radius = size / 2;
    switch (shape) {
        case MarkShape::square:
            return polygonPath(4, radius * 1.2, 0.125);
        case MarkShape::triangle:
            return polygonPath(3, radius * 1.25);
        case MarkShape::diamond:
            return polygonPath(4, radius * 1.25);
        case MarkShape::pentagon:
            return polygonPath(5, radius * 1.15);
        case MarkShape::circle:
            break;
    }
    QPainterPath path;
    path.addEllipse(QPointF(0, 0), radius, radius);
    return path;
}

void paintMark(QPainter& painter, const QPointF& at, const ChartInk& look, bool hollow, double size,
               double line) {
    painter.setPen(QPen(hollow ? look.colour : ink::paper, line));
    painter.setBrush(hollow ? ink::paper : look.colour);
    painter.drawPath(markPath(look.shape, size).translated(at));
    painter.setBrush(Qt::NoBrush);  // later lines must not be filled
}

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
