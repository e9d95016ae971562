#include "app/window/widgets/marked_slider.h"

#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>
#include <algorithm>

namespace noonmark {

namespace {

constexpr int labelSpacePx = 4;
constexpr QColor sunnyColour{0xf2, 0xb8, 0x3a};

QFont labelFont(const QWidget& widget) {
    QFont font = widget.font();
    font.setPointSizeF(0.8 * font.pointSizeF());
    return font;
}

}  // namespace

MarkedSlider::MarkedSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {}

void MarkedSlider::setMarks(std::vector<Mark> marks) {
    if (marks == marks_) return;
    marks_ = std::move(marks);
    update();
}

void MarkedSlider::setBright(int first, int last) {
    if (first == firstBright_ && last == lastBright_) return;
    firstBright_ = first;
    lastBright_ = last;
    update();
}

QSize MarkedSlider::sizeHint() const {
    return {160, QSlider::sizeHint().height() + QFontMetrics(labelFont(*this)).height() / 2 + labelSpacePx};
}

QSize MarkedSlider::minimumSizeHint() const { return {60, sizeHint().height()}; }

int MarkedSlider::handleWidth() const { return style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this); }

double MarkedSlider::pixelOf(int value) const {
    const int length = handleWidth();
    return length / 2.0 +
           QStyle::sliderPositionFromValue(minimum(), maximum(), value, std::max(1, width() - length));
}

void MarkedSlider::paintEvent(QPaintEvent* event) {
    QPainter painter(this);
    painter.setFont(labelFont(*this));
    const int middle = height() / 2;
    if (lastBright_ > firstBright_)
        painter.fillRect(
            QRectF(QPointF(pixelOf(firstBright_), middle + 4), QPointF(pixelOf(lastBright_), middle + 6)),
            sunnyColour);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    for (const Mark& mark : marks_) {
        const double x = pixelOf(mark.value);
        painter.drawLine(QPointF(x, middle + 4), QPointF(x, middle + 8));
        const double half = painter.fontMetrics().horizontalAdvance(mark.label) / 2.0;
        const double left = std::clamp(x - half, 0.0, std::max(0.0, width() - 2 * half));
        painter.drawText(QPointF(left, height() - 1), mark.label);
    }
    painter.end();
    QSlider::paintEvent(event);
}

void MarkedSlider::mousePressEvent(QMouseEvent* event) {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const QRect handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
    if (event->button() == Qt::LeftButton && !handle.contains(event->position().toPoint())) {
        const int length = handleWidth();
        setValue(QStyle::sliderValueFromPosition(minimum(), maximum(),
                                                 int(event->position().x()) - length / 2, width() - length));
    }
    QSlider::mousePressEvent(event);
}

}  // namespace noonmark
