#include "app/gui/frame/help/help_actions.h"

#include <QApplication>
#include <QMainWindow>
#include <QMessageBox>
#include <QWhatsThis>

#include "app/gui/base/widgets/make_action.h"
#include "app/gui/frame/actions/opening_actions.h"
#include "app/gui/frame/help/about_text.h"
#include "app/gui/frame/help/guide_window.h"
#include "app/gui/frame/help/start_dialog.h"

namespace noonmark {

HelpActions::HelpActions(OpeningActions& opening, QSettings& settings, QMainWindow& window)
    : opening_(opening),
      settings_(settings),
      window_(window),
      fields_([this](const GuidePlace& place) { showGuide(place); }),
      guide_(makeAction(this, tr("User &guide"), QKeySequence::HelpContents,
                        tr("The guide, at the page about the panel in use"), "help")),
      whatsThis_(makeAction(this, tr("&What's this?"), QKeySequence::WhatsThis,
                            tr("Explains the field that is clicked next; in a field, Shift+F1"), "help")),
      start_(makeAction(this, tr("&Start page"), {}, tr("Samples and recent projects"), "open")),
      about_(makeAction(this, tr("&About Noonmark"), {}, tr("Version, libraries and processor"), "about")) {
    connect(guide_, &QAction::triggered, this,
            [this] { showGuide(findGuidePlace(QApplication::focusWidget())); });
    connect(whatsThis_, &QAction::triggered, this, [] { QWhatsThis::enterWhatsThisMode(); });
    connect(start_, &QAction::triggered, this, &HelpActions::showStart);
    connect(about_, &QAction::triggered, this, &HelpActions::showAbout);
}

void HelpActions::showStart() {
    auto* dialog = new StartDialog(RecentFiles(settings_), &window_);
    connect(dialog, &StartDialog::chosen, &opening_, &OpeningActions::openWith);
    connect(dialog, &StartDialog::openRequested, opening_.openAction(), &QAction::trigger);
    connect(dialog, &StartDialog::guideRequested, this, [this] {
        showGuide({QStringLiteral("window"), {}});
    });
    connect(dialog, &StartDialog::tourRequested, this, &HelpActions::tourWanted);
    dialog->show();
}

// Above a modal dialog, which would keep the mouse from a guide that belongs to the window.
GuideWindow& HelpActions::showGuide(const GuidePlace& place) {
    QWidget* modal = QApplication::activeModalWidget();
    QWidget* owner = modal != nullptr ? modal : &window_;
    if (shown_ && shown_->parentWidget() != owner) delete shown_;
    if (!shown_) shown_ = new GuideWindow(owner);
    shown_->show();
    shown_->raise();
    shown_->showPage(place.page, place.section);
    return *shown_;
}

void HelpActions::showAbout() {
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Noonmark"), makeAboutText(),
                                QMessageBox::Close, &window_);
    box->setObjectName(QStringLiteral("about"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextInteractionFlags(Qt::TextSelectableByMouse);
    box->open();
}

}  // namespace noonmark
