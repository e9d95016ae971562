#include "app/gui/frame/actions/recent_menu.h"

#include <QAction>
#include <QMenu>

namespace noonmark {

RecentMenu::RecentMenu(QMenu& menu, QSettings& settings) : menu_(menu), recent_(settings) { fill(); }

void RecentMenu::add(const QStringList& files, const ReadSettings& reading) {
    recent_.add(files, reading);
    fill();
}

void RecentMenu::fill() {
    menu_.clear();
    for (const QString& entry : recent_.entries()) {
        const QString reading = recent_.readingTextOf(entry);
        const QString name = RecentFiles::nameOf(entry);
        QAction* action = menu_.addAction(reading.isEmpty() ? name : tr("%1, with options").arg(name));
        action->setStatusTip(reading.isEmpty() ? entry : tr("%1, read with %2").arg(entry, reading));
        connect(action, &QAction::triggered, this,
                [this, entry] { Q_EMIT chosen(RecentFiles::filesOf(entry), recent_.readingOf(entry)); });
    }
    menu_.setEnabled(!menu_.isEmpty());
}

}  // namespace noonmark
