#include "app/gui/frame/actions/search_actions.h"

#include <QMenuBar>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/docks/search/city_search.h"
#include "app/gui/session/workbench.h"
#include "app/gui/tools/editing/edit_tools.h"
#include "app/gui/view/panel/view_panel.h"

namespace noonmark {

namespace {

constexpr float minSideM = 120;  // of the ground that is shown around what was found

Box2 widened(Box2 box) {
    const glm::vec2 middle = (box.low + box.high) / 2.0F;
    const glm::vec2 half = glm::max((box.high - box.low) * 0.75F, glm::vec2(minSideM / 2));
    return {middle - half, middle + half};
}

}  // namespace

SearchActions::SearchActions(Workbench& workbench, EditTools& tools, ViewPanel& panel)
    : workbench_(workbench),
      tools_(tools),
      panel_(panel),
      field_(new SearchField),
      find_(makeAction(this, tr("&Find"), QKeySequence::Find,
                       tr("A building by name or id, a street, a place, a lot, a position or a command"),
                       "find")) {
    connect(find_, &QAction::triggered, field_, &SearchField::begin);
    connect(field_, &SearchField::found, this, &SearchActions::show);
    connect(field_, &SearchField::nothingFound, this, [this](const QString& text) {
        panel_.messages().showNote(tr("Nothing is called \"%1\", and no command that can be used now. "
                                      "Buildings without a name are found by "
                                      "their id.")
                                       .arg(text));
    });
    connect(&workbench_, &Workbench::cityShown, this, &SearchActions::renew);
    connect(&workbench_.session(), &ProjectSession::changed, this, &SearchActions::renew);
}

void SearchActions::renew() {
    field_->setIndex([this] {
        const Project& project = workbench_.session().project();
        const auto city = workbench_.city();
        CitySearch index = city ? CitySearch(city->city(), project.places, project.lots) : CitySearch();
        if (menus_ == nullptr) return index;
        for (const QAction* menu : menus_->actions())
            if (menu->menu() != nullptr) index.addCommands(*menu->menu());
        return index;
    });
}

void SearchActions::findCommandsOf(const QMenuBar& menus) {
    menus_ = &menus;
    renew();
}

void SearchActions::show(const Found& found) {
    if (found.kind == FoundKind::command) {
        // Later: the list that it was chosen in writes its title into the field.
        QMetaObject::invokeMethod(field_, &QLineEdit::clear, Qt::QueuedConnection);
        return found.command ? found.command->trigger() : void();
    }
    panel_.navigator().showSlanting(widened(found.box));
    if (found.building) tools_.building().select(found.building);
    if (found.kind == FoundKind::place) panel_.highlightPlace(found.name);
}

}  // namespace noonmark
