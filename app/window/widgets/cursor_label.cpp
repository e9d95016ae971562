#include "app/window/widgets/cursor_label.h"

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
    setText(text);
    adjustSize();
    move(view_.mapToGlobal((pixel + QPointF(left_(), 0)).toPoint()) + besideCursor);
    QLabel::show();
}

}  // namespace noonmark
