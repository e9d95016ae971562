#include "app/window/recent_menu.h"

#include <QAction>
#include <QMenu>

namespace noonmark {

RecentMenu::RecentMenu(QMenu& menu, QSettings& settings) : menu_(menu), recent_(settings) { fill(); }

void RecentMenu::add(const QStringList& files) {
    recent_.add(files);
    fill();
}

void RecentMenu::fill() {
    menu_.clear();
    for (const QString& entry : recent_.entries()) {
        QAction* action = menu_.addAction(RecentFiles::nameOf(entry));
        action->setStatusTip(entry);
        connect(action, &QAction::triggered, this,
                [this, entry] { Q_EMIT chosen(RecentFiles::filesOf(entry)); });
    }
    menu_.setEnabled(!menu_.isEmpty());
}

}  // namespace noonmark
