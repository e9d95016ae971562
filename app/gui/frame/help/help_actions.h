#pragma once

#include <QObject>
#include <QPointer>

#include "app/gui/frame/help/field_help.h"
#include "app/gui/frame/help/guide_place.h"

class QAction;
class QMainWindow;
class QSettings;

namespace noonmark {

class GuideWindow;
class OpeningActions;

/// The menu Help: the user guide (F1, at the place about the dock or dialog that has the focus), What's this
/// (Shift+F1), the page to start from, and what the program is made of.
class HelpActions final : public QObject {
    Q_OBJECT
public:
    /// The window owns the dialogs. All must outlive this object.
    HelpActions(OpeningActions& opening, QSettings& settings, QMainWindow& window);

    [[nodiscard]] QAction* guide() const { return guide_; }
    [[nodiscard]] QAction* whatsThis() const { return whatsThis_; }
    [[nodiscard]] QAction* start() const { return start_; }
    [[nodiscard]] QAction* about() const { return about_; }

    void showStart();  ///< what to open first
    GuideWindow& showGuide(const GuidePlace& place);

Q_SIGNALS:
    void tourWanted(std::size_t tour);  ///< an index of listTours(), from the start page

private:
    void showAbout();

    OpeningActions& opening_;
    QSettings& settings_;
    QMainWindow& window_;
    QPointer<GuideWindow> shown_;
    FieldHelp fields_;
    QAction* guide_;
    QAction* whatsThis_;
    QAction* start_;
    QAction* about_;
};

}  // namespace noonmark
