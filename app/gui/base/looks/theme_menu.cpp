#include "app/gui/base/looks/theme_menu.h"

#include <QActionGroup>
#include <QSettings>

#include "app/gui/base/looks/application_theme.h"

namespace noonmark {

ThemeMenu::ThemeMenu(QSettings& settings, QWidget* parent) : QMenu(tr("C&olours"), parent) {
    auto* group = new QActionGroup(this);
    for (const auto& [choice, name] :
         {std::pair{ThemeChoice::system, tr("As the &system")}, std::pair{ThemeChoice::light, tr("&Light")},
          std::pair{ThemeChoice::dark, tr("&Dark")}}) {
        QAction* action = group->addAction(name);
        action->setCheckable(true);
        connect(this, &QMenu::aboutToShow, action, [action, choice = choice, &settings] {
            action->setChecked(choice == readThemeChoice(settings));
        });
        connect(action, &QAction::triggered, this, [choice = choice, &settings] {
            saveThemeChoice(choice, settings);
            if (auto* theme = ApplicationTheme::inUse()) theme->choose(choice);
        });
    }
    addActions(group->actions());
}

}  // namespace noonmark
