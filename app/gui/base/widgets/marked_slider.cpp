#include "app/gui/base/widgets/marked_slider.h"

#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>
#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

constexpr int tickEndPx = 6;  // below the groove
constexpr double labelGapPx = 5;
constexpr QColor sunnyColour{0xf2, 0xb8, 0x3a};

QFont labelFont(const QWidget& widget) {
    QFont font = widget.font();
    font.setPointSizeF(0.8 * font.pointSizeF());
    return font;
}

bool areApart(const std::vector<MarkedSlider::Label>& labels) {
    for (std::size_t i = 1; i < labels.size(); ++i)
        if (labels[i].box.left() < labels[i - 1].box.right() + labelGapPx) return false;
    return true;
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
    // The groove is in the middle.
    const int below = tickEndPx + int(std::ceil(QFontMetricsF(labelFont(*this)).height()));
    return {160, std::max(QSlider::sizeHint().height(), 2 * below)};
}

QSize MarkedSlider::minimumSizeHint() const { return {60, sizeHint().height()}; }

int MarkedSlider::handleWidth() const { return style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this); }

double MarkedSlider::pixelOf(int value) const {
    const int length = handleWidth();
    return length / 2.0 +
           QStyle::sliderPositionFromValue(minimum(), maximum(), value, std::max(1, width() - length));
}

std::vector<MarkedSlider::Label> MarkedSlider::allLabels(bool shortened) const {
    const QFontMetricsF metrics(labelFont(*this));
    std::vector<Label> labels;
    for (const Mark& mark : marks_) {
        const QString& text = shortened && !mark.shortLabel.isEmpty() ? mark.shortLabel : mark.label;
        const double textWidth = metrics.horizontalAdvance(text);
        const double left =
            std::clamp(pixelOf(mark.value) - textWidth / 2, 0.0, std::max(0.0, width() - textWidth));
        labels.push_back({text, {left, height() / 2.0 + tickEndPx, textWidth, metrics.height()}});
    }
    std::erase_if(labels, [](const Label& label) { return label.text.isEmpty(); });
    return labels;
}

std::vector<MarkedSlider::Label> MarkedSlider::labels() const {
    if (auto all = allLabels(false); areApart(all)) return all;
    std::vector<Label> fitting;
    for (Label& label : allLabels(true))
        if (fitting.empty() || areApart({fitting.back(), label})) fitting.push_back(std::move(label));
    return fitting;
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
        painter.drawLine(QPointF(x, middle + 4), QPointF(x, middle + tickEndPx));
    }
    for (const Label& label : labels())
        painter.drawText(QPointF(label.box.left(), label.box.top() + painter.fontMetrics().ascent()),
                         label.text);
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
