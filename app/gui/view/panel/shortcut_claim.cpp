#include "app/gui/view/panel/shortcut_claim.h"

#include <QKeyEvent>
#include <utility>

namespace noonmark {

ShortcutClaim::ShortcutClaim(QObject& view, std::function<bool(int)> claims) : claims_(std::move(claims)) {
    view.installEventFilter(this);
}

// Accepting the event that Qt sends before it looks for a shortcut makes the key an ordinary one.
bool ShortcutClaim::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride) return QObject::eventFilter(watched, event);
    const auto& key = static_cast<QKeyEvent&>(*event);
    const bool plain = !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    if (!plain || !claims_(key.key())) return QObject::eventFilter(watched, event);
    event->accept();
    return true;
}

}  // namespace noonmark
