#include "app/gui/frame/preferences/preferences_actions.h"

#include "app/gui/base/widgets/make_action.h"
#include "app/gui/base/widgets/message_bar.h"
#include "app/gui/frame/preferences/preferences_dialog.h"

namespace noonmark {

PreferencesActions::PreferencesActions(QSettings& settings, MessageBar& messages, QWidget& window)
    : settings_(settings),
      messages_(messages),
      window_(window),
      show_(makeAction(this, tr("Pr&eferences..."), QKeySequence(tr("Ctrl+,")),
                       tr("Language, colours, units, paper and start page"))) {
    show_->setMenuRole(QAction::PreferencesRole);
    connect(show_, &QAction::triggered, this, &PreferencesActions::show);
}

void PreferencesActions::show() {
    auto* dialog = new PreferencesDialog(settings_, &window_);
    connect(dialog, &PreferencesDialog::paperChosen, this, &PreferencesActions::paperChosen);
    connect(dialog, &PreferencesDialog::restartNeeded, this,
            [this] { messages_.showNote(tr("Language and units apply when Noonmark starts again.")); });
    dialog->open();
}

}  // namespace noonmark
