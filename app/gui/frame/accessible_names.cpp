#include "app/gui/frame/accessible_names.h"

#include <QAccessible>
#include <QGroupBox>
#include <QLineEdit>
#include <QTextDocumentFragment>
#include <QWidget>

namespace noonmark {

namespace {

QString plainLine(const QString& text) {
    const QString plain =
        Qt::mightBeRichText(text) ? QTextDocumentFragment::fromHtml(text).toPlainText() : text;
    return plain.section(QLatin1Char('\n'), 0, 0);
}

QString titleAround(const QWidget& widget) {
    for (const QWidget* around = widget.parentWidget(); around != nullptr; around = around->parentWidget()) {
        if (const auto* box = qobject_cast<const QGroupBox*>(around)) return box->title();
        if (!around->accessibleName().isEmpty()) return around->accessibleName();
        if (!around->windowTitle().isEmpty()) return around->windowTitle();
    }
    return {};
}

bool hasName(QWidget& widget) {
    QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(&widget);
    return spoken != nullptr && !spoken->text(QAccessible::Name).isEmpty();
}

QString findName(const QWidget& widget) {
    if (const QString tip = plainLine(widget.toolTip()); !tip.isEmpty()) return tip;
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget);
        line && !line->placeholderText().isEmpty())
        return line->placeholderText();
    return titleAround(widget);
}

}  // namespace

void nameForScreenReaders(QWidget& window) {
    for (QWidget* widget : window.findChildren<QWidget*>())
        if (widget->focusPolicy() != Qt::NoFocus && !hasName(*widget))
            widget->setAccessibleName(findName(*widget));
}

}  // namespace noonmark
