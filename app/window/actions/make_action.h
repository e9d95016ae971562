#pragma once

#include <QAction>

namespace noonmark {

/// An action that belongs to `owner`. `tip` is its status tip and tool tip; it may be empty.
inline QAction* makeAction(QObject* owner, const QString& text, const QKeySequence& keys = {},
                           const QString& tip = {}) {
    auto* action = new QAction(text, owner);
    action->setShortcut(keys);
    action->setStatusTip(tip);
    action->setToolTip(tip);
    return action;
}

}  // namespace noonmark
