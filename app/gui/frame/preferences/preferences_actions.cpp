#include "app/gui/frame/preferences/preferences_actions.h"

#include "app/gui/base/widgets/make_action.h"
#include "app/gui/frame/preferences/preferences_dialog.h"

namespace noonmark {

PreferencesActions::PreferencesActions(QSettings& settings, QWidget& window)
    : settings_(settings),
      window_(window),
      show_(makeAction(this, tr("Pr&eferences..."), QKeySequence(tr("Ctrl+,")),
                       tr("Language, colours, units, paper and start page"))) {
    show_->setMenuRole(QAction::PreferencesRole);
    connect(show_, &QAction::triggered, this, &PreferencesActions::show);
}

void PreferencesActions::show() {
    auto* dialog = new PreferencesDialog(settings_, &window_);
    connect(dialog, &PreferencesDialog::paperChosen, this, &PreferencesActions::paperChosen);
    connect(dialog, &PreferencesDialog::textsChanged, this, &PreferencesActions::textsChanged);
    dialog->open();
}

}  // namespace noonmark
