#include "app/report/legend_painter.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <cmath>

namespace noonmark {

namespace {

constexpr double titlePt = 8.5;
constexpr double labelPt = 7.5;
constexpr double barTopPt = 13;
constexpr double barHeightPt = 9;
constexpr double tickPt = 2.5;

void paintTitle(const Canvas& canvas, const QRectF& area, const Legend& legend) {
    QPainter& painter = canvas.painter;
    const QFont bold = textFont(canvas, titlePt, QFont::Bold);
    const double baseline = area.top() + titlePt * canvas.point;
    painter.setFont(bold);
    painter.setPen(ink::text);
    painter.drawText(QPointF(area.left(), baseline), legend.title);
    const double used = QFontMetricsF(bold).horizontalAdvance(legend.title + QStringLiteral("  "));
    painter.setFont(textFont(canvas, titlePt));
    painter.setPen(ink::quiet);
    const QString unit =
        QFontMetricsF(painter.font()).elidedText(legend.unit, Qt::ElideRight, area.width() - used);
    painter.drawText(QPointF(area.left() + used, baseline), unit);
}

QRectF barOf(const Canvas& canvas, const QRectF& area) {
    return {area.left(), area.top() + barTopPt * canvas.point, area.width(), barHeightPt * canvas.point};
}

void paintBar(const Canvas& canvas, const QRectF& bar) {
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int stops = 64;
    for (int i = 0; i <= stops; ++i) gradient.setColorAt(double(i) / stops, shadowColour(double(i) / stops));
    canvas.painter.setBrush(gradient);
    canvas.painter.setPen(linePen(canvas, ink::quiet, 0.4));
    canvas.painter.drawRect(bar);
}

int ticksOf(const LegendScale& scale) { return std::max(1, int(std::lround(scale.top / scale.tick))); }

/// Every how many ticks a label has room: the largest number is the widest.
int labelStride(const Canvas& canvas, const QRectF& bar, const LegendScale& scale) {
    const QFontMetricsF metrics(textFont(canvas, labelPt));
    const double needed = metrics.horizontalAdvance(QString::number(scale.top)) + 6 * canvas.point;
    const double between = bar.width() / ticksOf(scale);
    return std::max(1, int(std::ceil(needed / between)));
}

void paintLabel(const Canvas& canvas, const QRectF& bar, double x, const QString& label) {
    const QFontMetricsF metrics(canvas.painter.font());
    const double width = metrics.horizontalAdvance(label);
    const double left = std::clamp(x - width / 2, bar.left(), bar.right() - width);
    canvas.painter.drawText(QPointF(left, bar.bottom() + (tickPt + labelPt) * canvas.point), label);
}

void paintTicks(const Canvas& canvas, const QRectF& bar, const LegendScale& scale) {
    const int ticks = ticksOf(scale);
    const int stride = labelStride(canvas, bar, scale);
    canvas.painter.setFont(textFont(canvas, labelPt));
    for (int i = 0; i <= ticks; ++i) {
        const double x = bar.left() + bar.width() * i / ticks;
        canvas.painter.setPen(linePen(canvas, ink::quiet, 0.4));
        canvas.painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + tickPt * canvas.point));
        canvas.painter.setPen(ink::text);
        if (i % stride == 0) paintLabel(canvas, bar, x, QString::number(i * scale.tick));
    }
}

void paintPatch(const Canvas& canvas, const QRectF& patch, const QColor& colour, const QString& label) {
    canvas.painter.setBrush(colour);
    canvas.painter.setPen(linePen(canvas, ink::quiet, 0.4));
    canvas.painter.drawRect(patch);
    canvas.painter.setFont(textFont(canvas, labelPt));
    canvas.painter.setPen(ink::text);
    canvas.painter.drawText(QPointF(patch.right() + 4 * canvas.point, patch.bottom() - 1.5 * canvas.point),
                            label);
}

void paintPatches(const Canvas& canvas, const QRectF& bar) {
    const QSizeF size(bar.height() * 2, bar.height());
    paintPatch(canvas, {bar.topLeft(), size}, shadowColour(0), QStringLiteral("in the sun"));
    paintPatch(canvas, {{bar.left() + bar.width() / 2, bar.top()}, size}, shadowColour(1),
               QStringLiteral("in shadow"));
}

}  // namespace

Legend legendOf(const ShadowField& field, ShadowMeasure measure) {
    if (isInstant(field)) return {QStringLiteral("Shadow"), QStringLiteral("at this moment"), {1, 1}, true};
    return {nameOf(measure), aboutOf(measure), legendScale(topOf(field, measure)), false};
}

void paintLegend(const Canvas& canvas, const QRectF& area, const Legend& legend) {
    canvas.painter.save();
    canvas.painter.setRenderHint(QPainter::Antialiasing);
    const QRectF bar = barOf(canvas, area);
    paintTitle(canvas, area, legend);
    if (legend.instant) {
        paintPatches(canvas, bar);
    } else {
        paintBar(canvas, bar);
        paintTicks(canvas, bar, legend.scale);
    }
    canvas.painter.restore();
}

QImage legendImage(const Legend& legend, const QSize& size, double devicePixelRatio) {
    QImage image(size * devicePixelRatio, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    const double point = image.height() / legendHeightPt;
    QPainter painter(&image);
    paintLegend({painter, point}, QRectF(image.rect()).adjusted(point, 0, -point, 0), legend);
    painter.end();
    image.setDevicePixelRatio(devicePixelRatio);
    return image;
}

}  // namespace noonmark
