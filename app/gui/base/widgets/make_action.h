#pragma once

#include <QAction>

#include "app/gui/base/looks/icons.h"

namespace noonmark {

/// An action that belongs to `owner`. `tip` is its status tip and tool tip; it may be empty. `icon`: a name
/// for makeIcon(); null: none.
inline QAction* makeAction(QObject* owner, const QString& text, const QKeySequence& keys = {},
                           const QString& tip = {}, const char* icon = nullptr) {
    auto* action = new QAction(text, owner);
    action->setShortcut(keys);
    action->setStatusTip(tip);
    action->setToolTip(tip);
    if (icon != nullptr) action->setIcon(makeIcon(QString::fromLatin1(icon)));
    return action;
}

}  // namespace noonmark
