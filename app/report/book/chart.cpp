#include "app/report/book/chart.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/report/book/diagram.h"
#include "app/report/maps/palette.h"
#include "app/report/sheets/study_words.h"

namespace noonmark {

namespace {

constexpr double labelPt = 6.6;

/// A round step that divides a range of values into at most `most` parts.
double roundStep(double range, int most) {
    const double least = range / most;
    const double decade = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * decade >= least * (1 - 1e-9)) return factor * decade;
    return 10 * decade;
}

QString timeText(double minutes) {
    return QStringLiteral("%1:%2")
        .arg(int(minutes) / 60, 2, 10, QChar(u'0'))
        .arg(int(minutes) % 60, 2, 10, QChar(u'0'));
}

/// The plot of a chart with its axes. Values grow upwards.
class Plot {
public:
    Plot(const Canvas& canvas, const QRectF& area, double scale, double fromX, double toX, double toY,
         double fromY = 0)
        : canvas_(canvas), scale_(scale), fromX_(fromX), toX_(toX), toY_(toY), fromY_(fromY) {
        const double unit = scale * canvas.point;
        area_ = area.adjusted(52 * unit, 6 * unit, -10 * unit, -14 * unit);
        font_ = textFont(canvas, labelPt * scale);
    }

    [[nodiscard]] const QRectF& area() const { return area_; }
    [[nodiscard]] double xAt(double value) const {
        return area_.left() + (value - fromX_) / (toX_ - fromX_) * area_.width();
    }
    [[nodiscard]] double yAt(double value) const {
        return area_.bottom() - (value - fromY_) / (toY_ - fromY_) * area_.height();
    }
    [[nodiscard]] QPointF at(double x, double y) const { return {xAt(x), yAt(y)}; }

    /// Lines across with their values, and the share of `whole` at the last one if there is a whole.
    void paintValues(const QString& unit) const {
        const double step = roundStep(toY_ - fromY_, 5);
        for (double value = fromY_; value <= toY_ * (1 + 1e-9); value += step) {
            line({area_.left(), yAt(value)}, {area_.right(), yAt(value)});
            const bool isTop = value + step > toY_ * (1 + 1e-9);
            label({area_.left() - 3 * canvas_.point, yAt(value)},
                  describeAmount(value, std::abs(value) < 10 && value != 0 ? 2 : 0) +
                      (isTop ? unit : QString()),
                  Qt::AlignRight | Qt::AlignVCenter);
        }
    }

    void paintTimes() const {
        const double hours = (toX_ - fromX_) / 60;
        const double step = hours > 12 ? 180 : hours > 6 ? 120 : 60;
        for (double time = std::ceil(fromX_ / step) * step; time <= toX_ + 1e-6; time += step) {
            line({xAt(time), area_.top()}, {xAt(time), area_.bottom()});
            label({xAt(time), area_.bottom() + 2 * canvas_.point}, timeText(time),
                  Qt::AlignHCenter | Qt::AlignTop);
        }
    }

    void line(QPointF from, QPointF to) const {
        canvas_.painter.setPen(linePen(canvas_, ink::line, 0.35));
        canvas_.painter.drawLine(from, to);
    }

    void label(QPointF at, const QString& text, Qt::Alignment alignment) const {
        const QFontMetricsF metrics(font_, canvas_.painter.device());
        QPointF from = at;
        const double width = metrics.horizontalAdvance(text);
        if (alignment & Qt::AlignRight) from.rx() -= width;
        if (alignment & Qt::AlignHCenter) from.rx() -= width / 2;
        from.ry() += alignment & Qt::AlignVCenter ? metrics.capHeight() / 2 : metrics.ascent();
        canvas_.painter.setFont(font_);
        canvas_.painter.setPen(ink::quiet);
        canvas_.painter.drawText(from, text);
    }

    void frame() const {
        canvas_.painter.setBrush(Qt::NoBrush);
        canvas_.painter.setPen(linePen(canvas_, ink::quiet, 0.5));
        canvas_.painter.drawRect(area_);
    }

private:
    Canvas canvas_;
    double scale_, fromX_, toX_, toY_, fromY_;
    QRectF area_;
    QFont font_;
};

/// The area between two heights over time, broken at gaps.
template <class Low, class High>
QPainterPath bandOf(const Plot& plot, const PageTimeline& chart, const Low& low, const High& high) {
    QPainterPath path;
    const auto& points = chart.points;
    for (std::size_t first = 0; first < points.size();) {
        std::size_t last = first + 1;
        while (last < points.size() &&
               points[last].minute - points[last - 1].minute < 1.5 * chart.stepMinutes)
            ++last;
        QPolygonF ring;
        for (std::size_t i = first; i < last; ++i) {
            ring << plot.at(points[i].minute, high(points[i]));
            ring << plot.at(points[i].minute + chart.stepMinutes, high(points[i]));
        }
        for (std::size_t i = last; i-- > first;) {
            ring << plot.at(points[i].minute + chart.stepMinutes, low(points[i]));
            ring << plot.at(points[i].minute, low(points[i]));
        }
        path.addPolygon(ring);
        path.closeSubpath();
        first = last;
    }
    return path;
}

void paintBands(const Canvas& canvas, const Plot& plot, const PageTimeline& chart) {
    using P = const TimelinePoint&;
    const auto none = [](P) { return 0.0; };
    const auto baseline = [](P p) { return p.baselineM2; };
    const auto lowered = [](P p) { return p.baselineM2 - p.gainedM2; };
    const auto raised = [](P p) { return p.baselineM2 + p.incrementalM2; };
    canvas.painter.fillPath(bandOf(plot, chart, none, baseline), shade::baseline);
    canvas.painter.fillPath(bandOf(plot, chart, lowered, baseline), shade::gained);
    canvas.painter.fillPath(bandOf(plot, chart, baseline, raised), shade::incremental);
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(linePen(canvas, shade::proposal, 0.9));
    QPolygonF line;
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
        const TimelinePoint& p = chart.points[i];
        if (i > 0 && p.minute - chart.points[i - 1].minute > 1.5 * chart.stepMinutes) {
            canvas.painter.drawPolyline(line);
            line.clear();
        }
        line << plot.at(p.minute, p.scenarioM2) << plot.at(p.minute + chart.stepMinutes, p.scenarioM2);
    }
    canvas.painter.drawPolyline(line);
}

QRectF withoutCaption(const Canvas& canvas, const QRectF& area, const Caption& caption, double scale) {
    const double height = captionPt(scale) * canvas.point;
    paintCaption(canvas, {area.left(), area.top(), area.width(), height}, caption, scale);
    return area.adjusted(0, height, 0, 0);
}

/// A strip of colours with labels at its ends, at the right edge below the carpet.
void paintShares(const Canvas& canvas, const QRectF& area, bool isIncremental, double scale) {
    constexpr int parts = 10;
    const double unit = scale * canvas.point;
    const QRectF strip(area.right() - 130 * unit, area.top(), 90 * unit, 6 * unit);
    for (int i = 0; i < parts; ++i)
        canvas.painter.fillRect(QRectF(strip.left() + strip.width() * i / parts, strip.top(),
                                       strip.width() / parts, strip.height()),
                                carpetColour(i / double(parts - 1), isIncremental));
    const QFont font = textFont(canvas, labelPt * scale);
    paintLines(canvas, {strip.left() - 30 * unit, strip.top() - unit, 26 * unit, 8 * unit},
               QStringLiteral("0 %"), font, ink::quiet, Qt::AlignRight);
    paintLines(canvas, {strip.right() + 4 * unit, strip.top() - unit, 30 * unit, 8 * unit},
               QStringLiteral("100 %"), font, ink::quiet);
}

}  // namespace

QColor carpetColour(double share, bool isIncremental) {
    if (std::isnan(share)) return ink::paper;
    if (!isIncremental) return shadowColour(share);
    if (share <= 0) return {0xee, 0xef, 0xf1};
    return impactColour(0.15 + 0.85 * share);
}

/// The place's area, unless little of it is ever in shadow.
static double topOf(const PageTimeline& chart) {
    constexpr double leastShare = 0.2, headroom = 1.15;
    double most = 0;
    for (const TimelinePoint& point : chart.points)
        most = std::max({most, point.baselineM2 + point.incrementalM2, point.scenarioM2});
    return std::max(1.0, most < leastShare * chart.areaM2 ? headroom * most : chart.areaM2);
}

void paintTimeline(const Canvas& canvas, const QRectF& area, const PageTimeline& chart) {
    const QRectF rest = withoutCaption(canvas, area, chart.caption, chart.textScale);
    const Plot plot(canvas, rest, chart.textScale, chart.fromMin, std::max(chart.toMin, chart.fromMin + 1),
                    topOf(chart));
    canvas.painter.save();
    canvas.painter.setRenderHint(QPainter::Antialiasing);
    paintBands(canvas, plot, chart);
    plot.paintValues(QStringLiteral(" m²"));
    plot.paintTimes();
    plot.frame();
    canvas.painter.restore();
}

void paintCarpet(const Canvas& canvas, const QRectF& area, const PageCarpet& chart) {
    const QRectF rest = withoutCaption(canvas, area, chart.caption, chart.textScale);
    const double unit = chart.textScale * canvas.point;
    const Plot plot(canvas, rest.adjusted(0, 0, 0, -12 * unit), chart.textScale, 0,
                    std::max(1, chart.image.width()), chart.toMin - chart.fromMin);
    canvas.painter.save();
    canvas.painter.setRenderHint(QPainter::LosslessImageRendering);
    canvas.painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    // Viewers blur coarse pictures: whole pixels for each cell keep its edges sharp.
    canvas.painter.drawImage(plot.area(),
                             chart.image.scaled(chart.image.width() * 4, chart.image.height() * 4));
    for (double time = std::ceil(chart.fromMin / 120) * 120; time <= chart.toMin; time += 120)
        plot.label({plot.area().left() - 3 * canvas.point, plot.yAt(time - chart.fromMin)}, timeText(time),
                   Qt::AlignRight | Qt::AlignVCenter);
    for (const PageCarpet::Month& month : chart.months) {
        plot.line({plot.xAt(month.at), plot.area().top()}, {plot.xAt(month.at), plot.area().bottom()});
        plot.label({plot.xAt(month.at) + canvas.point, plot.area().bottom() + 2 * canvas.point}, month.name,
                   Qt::AlignLeft | Qt::AlignTop);
    }
    plot.frame();
    paintShares(canvas, {plot.area().left(), rest.bottom() - 9 * unit, plot.area().width(), 9 * unit},
                chart.isIncremental, chart.textScale);
    canvas.painter.restore();
}

void paintBars(const Canvas& canvas, const QRectF& area, const PageBars& chart) {
    constexpr double groupShare = 0.8;
    const QRectF rest = withoutCaption(canvas, area, chart.caption, chart.textScale);
    double most = 0, least = 0;
    for (const auto& group : chart.groups)
        for (const double value : group.values) most = std::max(most, value), least = std::min(least, value);
    const double step = roundStep(std::max(1.0, most - least), 5);
    const Plot plot(canvas, rest, chart.textScale, 0, double(chart.groups.size()),
                    std::max(1.0, std::ceil(most / step)) * step, std::floor(least / step) * step);
    canvas.painter.save();
    plot.paintValues(u' ' + chart.unit);
    for (std::size_t i = 0; i < chart.groups.size(); ++i) {
        const auto& group = chart.groups[i];
        const double width = groupShare / double(group.values.size());
        for (std::size_t k = 0; k < group.values.size(); ++k) {
            const double from = double(i) + (1 - groupShare) / 2 + double(k) * width;
            canvas.painter.fillRect(
                QRectF(plot.at(from, group.values[k]), plot.at(from + 0.92 * width, 0)).normalized(),
                chart.colours[k]);
        }
        plot.label({plot.xAt(double(i) + 0.5), plot.area().bottom() + 2 * canvas.point}, group.name,
                   Qt::AlignHCenter | Qt::AlignTop);
    }
    plot.frame();
    canvas.painter.restore();
}

}  // namespace noonmark
