#include "app/gui/base/widgets/cursor_label.h"

#include <QScreen>
#include <QWindow>

namespace noonmark {

namespace {

constexpr QPoint besideCursor{18, 14};

}  // namespace

// A separate window, because no widget can be drawn over the view's native window.
CursorLabel::CursorLabel(QWindow& view, QWidget* parent)
    : QLabel(parent, Qt::ToolTip | Qt::WindowTransparentForInput | Qt::WindowDoesNotAcceptFocus),
      view_(view) {
    setObjectName(QStringLiteral("cursorLabel"));
    setTextFormat(Qt::PlainText);
    setAttribute(Qt::WA_ShowWithoutActivating);
    setStyleSheet(
        QStringLiteral("#cursorLabel { background: #fffef5; color: #1d2027; "
                       "border: 1px solid #9a9ea6; padding: 3px 6px; }"));
}

void CursorLabel::show(QPointF pixel, const QString& text) {
    if (text.isEmpty()) return hide();
    pixel_ = pixel;
    text_ = text;
    place();
    QLabel::show();
}

void CursorLabel::setLinesBelow(const QString& lines) {
    below_ = lines;
    if (isVisible()) place();
}

// On the other side of the cursor where it would reach beyond the screen.
void CursorLabel::place() {
    setText(below_.isEmpty() ? text_ : text_ + u'\n' + below_);
    adjustSize();
    const QPoint cursor = view_.mapToGlobal((pixel_ + QPointF(left_(), 0)).toPoint());
    QPoint corner = cursor + besideCursor;
    if (freeSide_.x() < 0) corner.setX(cursor.x() - besideCursor.x() - width());
    if (freeSide_.y() < 0) corner.setY(cursor.y() - besideCursor.y() - height());
    if (const QScreen* on = view_.screen()) {
        const QRect free = on->availableGeometry();
        if (corner.x() + width() > free.right()) corner.setX(cursor.x() - besideCursor.x() - width());
        if (corner.x() < free.left()) corner.setX(cursor.x() + besideCursor.x());
        if (corner.y() + height() > free.bottom()) corner.setY(cursor.y() - besideCursor.y() - height());
        if (corner.y() < free.top()) corner.setY(cursor.y() + besideCursor.y());
    }
    move(corner);
}

}  // namespace noonmark
