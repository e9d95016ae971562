#include "app/window/view_picture.h"

#include <QFontMetricsF>
#include <algorithm>

namespace noonmark {

namespace {

constexpr double pointPx = 1.6;
constexpr double marginPx = 16;
constexpr double legendWidthPx = 560;

// At the right; returns how much width is left for the legend.
double paintCredit(QPainter& painter, const QRectF& foot, const QString& credit) {
    const Canvas canvas{painter, pointPx};
    painter.setFont(textFont(canvas, 7.5));
    painter.setPen(ink::quiet);
    painter.drawText(foot, Qt::AlignRight | Qt::AlignBottom, credit);
    const double used =
        credit.isEmpty() ? 0 : QFontMetricsF(painter.font()).horizontalAdvance(credit) + marginPx;
    return std::max(foot.width() / 2, foot.width() - used);
}

}  // namespace

QImage viewPicture(const QImage& view, const std::optional<Legend>& legend, const QString& credit) {
    const int footPx = legend ? int(legendHeightPt * pointPx + 2 * marginPx) : 0;
    QImage picture(view.width(), view.height() + footPx, QImage::Format_RGB32);
    picture.fill(ink::paper);
    QPainter painter(&picture);
    painter.drawImage(QPointF(0, 0), view);
    if (!legend) return picture;
    const QRectF foot =
        QRectF(0, view.height(), view.width(), footPx).adjusted(marginPx, marginPx, -marginPx, -marginPx);
    QRectF bar = foot;
    bar.setWidth(std::min(paintCredit(painter, foot, credit), legendWidthPx));
    paintLegend({painter, pointPx}, bar, *legend);
    return picture;
}

}  // namespace noonmark
