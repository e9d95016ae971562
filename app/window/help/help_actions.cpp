#include "app/window/help/help_actions.h"

#include <QApplication>
#include <QMainWindow>
#include <QMessageBox>

#include "app/window/actions/make_action.h"
#include "app/window/actions/opening_actions.h"
#include "app/window/help/about_text.h"
#include "app/window/help/guide_window.h"
#include "app/window/help/start_dialog.h"

namespace noonmark {

HelpActions::HelpActions(OpeningActions& opening, QSettings& settings, QMainWindow& window)
    : opening_(opening),
      settings_(settings),
      window_(window),
      guide_(makeAction(this, tr("User &guide"), QKeySequence::HelpContents,
                        tr("The guide, at the page about the panel in use"), "help")),
      start_(makeAction(this, tr("&Start page"), {}, tr("Samples and recent projects"), "open")),
      about_(makeAction(this, tr("&About Noonmark"), {}, tr("Version, libraries and processor"), "about")) {
    connect(guide_, &QAction::triggered, this, [this] { showGuide(pageOfFocus()); });
    connect(start_, &QAction::triggered, this, &HelpActions::showStart);
    connect(about_, &QAction::triggered, this, &HelpActions::showAbout);
}

void HelpActions::showStart() {
    auto* dialog = new StartDialog(RecentFiles(settings_), &window_);
    connect(dialog, &StartDialog::chosen, &opening_, &OpeningActions::openWith);
    connect(dialog, &StartDialog::openRequested, opening_.openAction(), &QAction::trigger);
    connect(dialog, &StartDialog::guideRequested, this, [this] { showGuide(QStringLiteral("window")); });
    dialog->show();
}

GuideWindow& HelpActions::showGuide(const QString& page) {
    if (!shown_) shown_ = new GuideWindow(&window_);
    shown_->show();
    shown_->raise();
    shown_->showPage(page);
    return *shown_;
}

QString HelpActions::pageOfFocus() const {
    const std::pair<const char*, const char*> pages[] = {
        {"reviewDock", "review"}, {"resultsDock", "results"}, {"warningsDock", "data"}};
    for (const QWidget* widget = QApplication::focusWidget(); widget; widget = widget->parentWidget())
        for (const auto& [dock, page] : pages)
            if (widget->objectName() == QLatin1String(dock)) return QString::fromLatin1(page);
    return QStringLiteral("window");
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
