#include "app/gui/frame/help/help_actions.h"

#include <QApplication>
#include <QMainWindow>
#include <QMenuBar>
#include <QMessageBox>
#include <QWhatsThis>
#include <utility>

#include "app/gui/base/widgets/make_action.h"
#include "app/gui/frame/actions/opening_actions.h"
#include "app/gui/frame/help/about_text.h"
#include "app/gui/frame/help/guide_window.h"
#include "app/gui/frame/help/key_sheet.h"

namespace noonmark {

HelpActions::HelpActions(OpeningActions& opening, QSettings& settings, QMainWindow& window, ViewPanel& view)
    : opening_(opening),
      settings_(settings),
      window_(window),
      view_(view),
      fields_([this](const GuidePlace& place) { showGuide(place); }),
      guide_(makeAction(this, tr("User &guide"), QKeySequence::HelpContents,
                        tr("The guide, at the page about the panel in use"), "help")),
      whatsThis_(makeAction(this, tr("&What's this?"), QKeySequence::WhatsThis,
                            tr("Explains the field that is clicked next; in a field, Shift+F1"), "help")),
      keys_(makeAction(this, tr("&Mouse and keys"), {}, tr("All keys and what the mouse does, as a table"),
                       "keys")),
      start_(makeAction(this, tr("&Start page"), {}, tr("Recent projects, samples and questions"), "open")),
      about_(makeAction(this, tr("&About Noonmark"), {}, tr("Version, libraries and processor"), "about")) {
    connect(guide_, &QAction::triggered, this,
            [this] { showGuide(findGuidePlace(QApplication::focusWidget())); });
    keys_->setShortcuts({QKeySequence(tr("Ctrl+F1")), QKeySequence(Qt::Key_Question)});
    connect(keys_, &QAction::triggered, this, &HelpActions::showKeys);
    connect(whatsThis_, &QAction::triggered, this, [] { QWhatsThis::enterWhatsThisMode(); });
    connect(start_, &QAction::triggered, this, [this] { showStart(); });
    connect(about_, &QAction::triggered, this, &HelpActions::showAbout);
    connect(&opening_, &OpeningActions::begun, this, [this] {
        waiting_ = startPage_ ? startPage_->waiting() : std::nullopt;
        if (startPage_) startPage_->close();
    });
    connect(
        &opening_, &OpeningActions::opened, this,
        [this] {
            if (const auto question = std::exchange(waiting_, std::nullopt)) Q_EMIT questionAsked(*question);
        },
        Qt::QueuedConnection);
}

// The page follows the window, and must not outlast what it follows.
HelpActions::~HelpActions() { delete startPage_; }

void HelpActions::showStart(bool cityChosen) {
    delete startPage_;
    startPage_ = new StartPage(RecentFiles(settings_), cityChosen, window_, view_);
    connectStart(*startPage_);
    startPage_->show();
    startPage_->raise();
    startPage_->setFocus();
}

void HelpActions::connectStart(StartPage& page) {
    connect(&page, &StartPage::chosen, &opening_, &OpeningActions::openWith);
    connect(&page, &StartPage::openRequested, opening_.openAction(), &QAction::trigger);
    connect(&page, &StartPage::folderRequested, &opening_, &OpeningActions::openFolder);
    connect(&page, &StartPage::guideRequested, this, [this] { showGuide({QStringLiteral("window"), {}}); });
    connect(&page, &StartPage::tourRequested, this, &HelpActions::tourWanted);
    connect(&page, &StartPage::asked, this, [this, &page](StartQuestion question) {
        page.close();
        Q_EMIT questionAsked(question);
    });
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

void HelpActions::showKeys() {
    delete keySheet_;
    keySheet_ = new KeySheet(*window_.menuBar(), &window_);
    keySheet_->show();
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
