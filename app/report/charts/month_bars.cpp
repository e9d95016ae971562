#include "app/report/charts/month_bars.h"

#include <QLocale>
#include <algorithm>

namespace noonmark {

namespace {

constexpr QColor barColour{0xd5, 0x5e, 0x00};

}  // namespace

void paintMonthBars(const Canvas& canvas, const QRectF& area, const MonthBars& bars) {
    canvas.painter.save();
    canvas.painter.setRenderHint(QPainter::Antialiasing);
    const QRectF plot = plotIn(canvas, area);
    ChartAxis across{0, 12, {}, {}};
    const ChartAxis up = makeAmountAxis(std::ranges::max(bars.values), bars.unit);
    const QLocale english(QLocale::English);
    for (int month = 0; month < 12; ++month) {
        const double left = xOf(across, plot, month + 0.15), right = xOf(across, plot, month + 0.85);
        const double top = yOf(up, plot, bars.values[std::size_t(month)]);
        canvas.painter.fillRect(QRectF(QPointF(left, top), QPointF(right, plot.bottom())), barColour);
    }
    paintAxes(canvas, plot, across, up);
    canvas.painter.setPen(ink::quiet);
    canvas.painter.setFont(textFont(canvas, 7));
    for (int month = 0; month < 12; ++month) {
        const double left = xOf(across, plot, month), width = plot.width() / 12;
        const auto format = width / canvas.point > 22 ? QLocale::ShortFormat : QLocale::NarrowFormat;
        canvas.painter.drawText(QRectF(left, plot.bottom() + 2 * canvas.point, width, 10 * canvas.point),
                                Qt::AlignHCenter | Qt::AlignTop | Qt::TextDontClip,
                                english.monthName(month + 1, format));
    }
    paintKeys(canvas, plot, {{bars.text, barColour}});
    canvas.painter.restore();
}

}  // namespace noonmark
