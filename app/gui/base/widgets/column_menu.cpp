#include "app/gui/base/widgets/column_menu.h"

#include <QHeaderView>
#include <QMenu>
#include <QSettings>

namespace noonmark {

ColumnMenu::ColumnMenu(QHeaderView& heading, int keyRole, QSettings& settings, const QString& setting)
    : QObject(&heading), heading_(heading), keyRole_(keyRole), settings_(settings), setting_(setting) {
    const QStringList hidden = settings_.value(setting_).toStringList();
    for (int column = 1; column < heading_.count(); ++column)
        heading_.setSectionHidden(column, hidden.contains(keyOf(column)));
    heading_.setContextMenuPolicy(Qt::CustomContextMenu);
    connect(&heading_, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        QMenu* menu = makeMenu();
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->popup(heading_.mapToGlobal(at));
    });
}

QString ColumnMenu::keyOf(int column) const {
    return heading_.model()->headerData(column, Qt::Horizontal, keyRole_).toString();
}

QMenu* ColumnMenu::makeMenu() {
    auto* menu = new QMenu(&heading_);
    for (int column = 1; column < heading_.count(); ++column) {
        QString title = heading_.model()->headerData(column, Qt::Horizontal).toString();
        QAction* action = menu->addAction(title.replace(QLatin1Char('&'), QStringLiteral("&&")));
        action->setCheckable(true);
        action->setChecked(!heading_.isSectionHidden(column));
        connect(action, &QAction::toggled, this, [this, column](bool shown) { show(column, shown); });
    }
    return menu;
}

void ColumnMenu::show(int column, bool shown) {
    heading_.setSectionHidden(column, !shown);
    QStringList hidden;
    for (int i = 1; i < heading_.count(); ++i)
        if (heading_.isSectionHidden(i)) hidden << keyOf(i);
    settings_.setValue(setting_, hidden);
}

}  // namespace noonmark
