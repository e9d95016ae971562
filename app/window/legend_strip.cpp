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
constexpr QColor partColour{0xff, 0xd5, 0x8a};

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

void LegendStrip::setHint(const QString& hint) {
    hint_ = hint;
    update();
}

void LegendStrip::setNote(const QString& note, bool partial) {
    note_ = note;
    partial_ = partial;
    update();
}

void LegendStrip::setHeading(double degrees) {
    headingDeg_ = degrees;
    update();
}

ShadowMeasure LegendStrip::measure() const { return ShadowMeasure(measure_->currentIndex()); }

void LegendStrip::setMeasure(ShadowMeasure measure) { measure_->setCurrentIndex(int(measure)); }

// Left of the compass, on amber where it marks a part. Returns the width that is left for the legend.
double LegendStrip::paintNote(QPainter& painter) const {
    const double right = width() - compassWidth;
    const double room = right - measureWidth - 10;
    if (note_.isEmpty()) return room - 20;
    painter.setFont(textFont({painter, 1.0}, 11, partial_ ? QFont::Bold : QFont::Normal));
    const QRectF most(0, 0, room / 2 - 24, height());
    const QRectF words = QFontMetricsF(painter.font()).boundingRect(most, Qt::TextWordWrap, note_);
    const QRectF chip(right - words.width() - 20, (height() - words.height()) / 2 - 5, words.width() + 16,
                      words.height() + 10);
    if (partial_) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(partColour);
        painter.drawRoundedRect(chip, 4, 4);
    }
    painter.setPen(partial_ ? ink::text : ink::quiet);
    painter.drawText(chip, Qt::AlignCenter | Qt::TextWordWrap, note_);
    return chip.left() - measureWidth - 26;
}

void LegendStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), ink::paper);
    painter.fillRect(QRect(0, 0, width(), 1), ink::line);
    paintCompass(painter, {width() - compassWidth / 2.0, height() / 2.0 + 6}, headingDeg_);
    const QRectF area(measureWidth + 10, 8, std::min(640.0, paintNote(painter)), height() - 10);
    if (legend_) return paintLegend({painter, area.height() / legendHeightPt}, area, *legend_);
    painter.setPen(ink::quiet);
    painter.setFont(font());
    painter.drawText(area, Qt::AlignVCenter | Qt::AlignLeft | Qt::TextWordWrap, hint_);
}

}  // namespace noonmark
