#pragma once

#include <QObject>
#include <QPointer>

#include "app/gui/frame/help/field_help.h"
#include "app/gui/frame/help/guide_place.h"
#include "app/gui/frame/help/start_page.h"

class QAction;
class QMainWindow;
class QSettings;

namespace noonmark {

class GuideWindow;
class KeySheet;
class OpeningActions;
class ViewPanel;

/// The menu Help: the user guide (F1, at the place about the dock or dialog that has the focus), What's this
/// (Shift+F1), the page to start from, and what the program is made of.
class HelpActions final : public QObject {
    Q_OBJECT
public:
    /// The window owns the dialogs; `view` is what the start page leaves in sight. All must outlive this
    /// object.
    HelpActions(OpeningActions& opening, QSettings& settings, QMainWindow& window, ViewPanel& view);

    ~HelpActions() override;

    [[nodiscard]] QAction* guide() const { return guide_; }
    [[nodiscard]] QAction* whatsThis() const { return whatsThis_; }
    [[nodiscard]] QAction* keys() const { return keys_; }  ///< mouse and keys
    [[nodiscard]] QAction* start() const { return start_; }
    [[nodiscard]] QAction* about() const { return about_; }

    /// What to open, and what to ask. `cityChosen`: the user has a city open, not only the first sample.
    void showStart(bool cityChosen = true);
    GuideWindow& showGuide(const GuidePlace& place);

Q_SIGNALS:
    void tourWanted(std::size_t tour);  ///< an index of listTours(), from the start page
    /// A card of the start page was chosen, and its city is there.
    void questionAsked(noonmark::StartQuestion question);

private:
    void showAbout();
    void showKeys();
    void connectStart(StartPage& page);

    OpeningActions& opening_;
    QSettings& settings_;
    QMainWindow& window_;
    ViewPanel& view_;
    QPointer<GuideWindow> shown_;
    QPointer<KeySheet> keySheet_;
    QPointer<StartPage> startPage_;
    std::optional<StartQuestion> waiting_;  ///< for the city that is being opened
    FieldHelp fields_;
    QAction* guide_;
    QAction* whatsThis_;
    QAction* keys_;
    QAction* start_;
    QAction* about_;
};

}  // namespace noonmark
