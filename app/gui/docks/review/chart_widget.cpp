#include "app/gui/docks/review/chart_widget.h"

#include <QMouseEvent>
#include <QPainter>
#include <utility>

#include "app/gui/base/looks/theme.h"
#include "app/report/charts/chart_axes.h"

namespace noonmark {

namespace {

constexpr double pointsPerInch = 72;

}  // namespace

ChartWidget::ChartWidget(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ChartWidget::show(Paint paint) {
    paint_ = std::move(paint);
    update();
}

double ChartWidget::point() const { return logicalDpiY() / pointsPerInch; }

QRectF ChartWidget::area() const { return QRectF(rect()).adjusted(2, 4, -4, -2); }

void ChartWidget::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const Inks inks = inksOf(themeInUse());
    painter.fillRect(rect(), inks.paper);
    if (paint_) paint_({painter, point(), inks}, area());
    const QRectF plot = plotIn(area(), point());
    if (!paint_ || !cursor_ || *cursor_ < plot.left() || *cursor_ > plot.right()) return;
    painter.setPen(QPen(inks.quiet, 1, Qt::DotLine));
    painter.drawLine(QPointF(*cursor_, plot.top()), QPointF(*cursor_, plot.bottom()));
}

void ChartWidget::mouseMoveEvent(QMouseEvent* event) {
    cursor_ = event->position().x();
    update();
    Q_EMIT hovered(event->position());
}

void ChartWidget::mousePressEvent(QMouseEvent* event) { Q_EMIT clicked(event->position()); }

void ChartWidget::leaveEvent(QEvent* /*event*/) {
    cursor_.reset();
    update();
    Q_EMIT left();
}

}  // namespace noonmark
