#include "app/gui/frame/tour/tour_bubble.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace noonmark {

namespace {

constexpr int frameWidth = 3;
constexpr int gap = 10;
constexpr int textWidth = 300;
constexpr int barsPx = 70;  // menus and toolbar at the top, which the text must not cover

}  // namespace

TourFrame::TourFrame(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void TourFrame::put(const QRect& control) {
    setVisible(!control.isEmpty());
    if (control.isEmpty()) return;
    setGeometry(control.adjusted(-frameWidth, -frameWidth, frameWidth, frameWidth));
    raise();
}

void TourFrame::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(0xe0, 0x6c, 0x10), frameWidth));
    const qreal half = frameWidth / 2.0;
    painter.drawRoundedRect(QRectF(rect()).adjusted(half, half, -half, -half), 4, 4);
}

TourBubble::TourBubble(QMainWindow& window)
    : QFrame(&window, Qt::Tool | Qt::FramelessWindowHint),
      window_(window),
      title_(new QLabel),
      text_(new QLabel),
      show_(new QPushButton),
      end_(new QPushButton) {
    setObjectName(QStringLiteral("tourBubble"));
    setAttribute(Qt::WA_ShowWithoutActivating);  // the keyboard stays with the window
    setFrameShape(QFrame::StyledPanel);
    text_->setObjectName(QStringLiteral("tourText"));
    text_->setWordWrap(true);
    text_->setFixedWidth(textWidth);
    title_->setForegroundRole(QPalette::PlaceholderText);
    show_->setObjectName(QStringLiteral("tourShowMe"));
    end_->setObjectName(QStringLiteral("tourEnd"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(show_);
    buttons->addStretch(1);
    buttons->addWidget(end_);
    auto* column = new QVBoxLayout(this);
    column->addWidget(title_);
    column->addWidget(text_);
    column->addLayout(buttons);
    connect(show_, &QPushButton::clicked, this, &TourBubble::showMe);
    connect(end_, &QPushButton::clicked, this, &TourBubble::ended);
}

void TourBubble::tell(const QString& title, const QString& text, Onward onward) {
    const bool last = onward == Onward::finish;
    title_->setText(title);
    text_->setText(text);
    show_->setVisible(!last);
    show_->setText(onward == Onward::next ? tr("Next") : tr("Show me"));
    show_->setToolTip(onward == Onward::next ? QString() : tr("Does this step for you"));
    end_->setText(last ? tr("Finish") : tr("End tour"));
    end_->setToolTip(last ? QString() : tr("Help > Guided tours starts it again"));
    adjustSize();
    show();
}

// Right of the control, else left, else below it, as of menus and tools; inside the window.
void TourBubble::put(const QRect& control) {
    const QRect room = window_.rect().adjusted(gap, gap, -gap, -gap);
    QPoint at = room.center() - rect().center();
    if (!control.isEmpty()) {
        at = {control.right() + gap, control.top()};
        if (at.x() + width() > room.right()) at.setX(control.left() - gap - width());
        const bool isInBars = control.bottom() < barsPx;
        if (at.x() < room.left() || isInBars) at = {control.left(), control.bottom() + gap};
    }
    at.setX(qBound(room.left(), at.x(), std::max(room.left(), room.right() - width())));
    at.setY(qBound(room.top(), at.y(), std::max(room.top(), room.bottom() - height())));
    const QPoint shown = window_.mapToGlobal(at);
    if (pos() != shown) move(shown);
}

}  // namespace noonmark
