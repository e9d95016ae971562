#include "app/window/legend_strip.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>

namespace noonmark {

namespace {

constexpr int stripHeight = 58;
constexpr int measureWidth = 190;
constexpr int compassWidth = 56;

void paintNeedle(QPainter& painter, const QColor& colour, bool north) {
    const double tip = north ? -17 : 17;
    QPainterPath half;
    half.moveTo(0, tip);
    half.lineTo(5, 0);
    half.lineTo(-5, 0);
    half.closeSubpath();
    painter.fillPath(half, colour);
}

void paintCompass(QPainter& painter, QPointF centre, double headingDeg) {
    painter.save();
    painter.translate(centre);
    painter.rotate(-headingDeg);
    paintNeedle(painter, ink::line, false);
    paintNeedle(painter, ink::text, true);
    painter.setPen(ink::text);
    painter.setFont(textFont({painter, 1.0}, 10, QFont::Bold));
    painter.drawText(QRectF(-8, -29, 16, 12), Qt::AlignCenter, QStringLiteral("N"));
    painter.restore();
}

}  // namespace

LegendStrip::LegendStrip(QWidget* parent) : QWidget(parent), measure_(new QComboBox) {
    setFixedHeight(stripHeight);
    measure_->setObjectName(QStringLiteral("measure"));
    measure_->addItem(nameOf(ShadowMeasure::gross));
    measure_->addItem(nameOf(ShadowMeasure::continuous));
    measure_->setToolTip(
        tr("What the ground shows.\nGross shadow: minutes in shadow a day, mean over the days.\n"
           "Continuous shadow: longest unbroken run in shadow on any day, minutes."));
    measure_->setFixedWidth(measureWidth - 24);
    connect(measure_, &QComboBox::currentIndexChanged, this, &LegendStrip::measureChanged);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 0, 12, 0);
    row->addWidget(measure_);
    row->addStretch(1);
}

void LegendStrip::setLegend(std::optional<Legend> legend) {
    legend_ = std::move(legend);
    update();
}

void LegendStrip::setHeading(double degrees) {
    headingDeg_ = degrees;
    update();
}

ShadowMeasure LegendStrip::measure() const { return ShadowMeasure(measure_->currentIndex()); }

void LegendStrip::setMeasure(ShadowMeasure measure) { measure_->setCurrentIndex(int(measure)); }

void LegendStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), ink::paper);
    painter.fillRect(QRect(0, 0, width(), 1), ink::line);
    paintCompass(painter, {width() - compassWidth / 2.0, height() / 2.0 + 6}, headingDeg_);
    const QRectF area(measureWidth + 10, 8, std::min(640, width() - measureWidth - compassWidth - 30),
                      height() - 10);
    if (legend_) return paintLegend({painter, area.height() / legendHeightPt}, area, *legend_);
    painter.setPen(ink::quiet);
    painter.drawText(area, Qt::AlignVCenter | Qt::AlignLeft,
                     tr("No study yet: choose a period and a region, then press Run (Ctrl+R)"));
}

}  // namespace noonmark
