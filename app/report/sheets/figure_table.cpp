#include "app/report/sheets/figure_table.h"

#include <QFontMetricsF>

namespace noonmark {

namespace {

constexpr double rowHeight = 1.62;  // times the font size

void paintRow(const Canvas& canvas, const QRectF& row, const FigureText& figure) {
    const QFontMetricsF metrics(canvas.painter.font());
    const double valueWidth = metrics.horizontalAdvance(figure.value);
    const double room = row.width() - valueWidth - metrics.averageCharWidth();
    canvas.painter.setPen(ink::text);
    canvas.painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter,
                            metrics.elidedText(figure.name, Qt::ElideRight, room));
    canvas.painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, figure.value);
    canvas.painter.setPen(linePen(canvas, ink::line, 0.4));
    canvas.painter.drawLine(row.bottomLeft(), row.bottomRight());
}

}  // namespace

double paintFigures(const Canvas& canvas, const QRectF& area, const std::vector<FigureText>& figures,
                    double points) {
    QRectF row(area.left(), area.top(), area.width(), rowHeight * points * canvas.point);
    for (std::size_t i = 0; i < figures.size(); ++i) {
        canvas.painter.setFont(textFont(canvas, points, i == 0 ? QFont::Bold : QFont::Normal));
        paintRow(canvas, row, figures[i]);
        row.translate(0, row.height());
    }
    return row.top();
}

}  // namespace noonmark
