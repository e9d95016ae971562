#pragma once

#include <QObject>
#include <QPointer>

class QAction;
class QMainWindow;
class QSettings;

namespace noonmark {

class GuideWindow;
class OpeningActions;

/// The menu Help: the user guide (F1, at the page about the dock that has the focus), the page to start from,
/// and what the program is made of.
class HelpActions final : public QObject {
    Q_OBJECT
public:
    /// The window owns the dialogs. All must outlive this object.
    HelpActions(OpeningActions& opening, QSettings& settings, QMainWindow& window);

    [[nodiscard]] QAction* guide() const { return guide_; }
    [[nodiscard]] QAction* start() const { return start_; }
    [[nodiscard]] QAction* about() const { return about_; }

    void showStart();                             ///< what to open first
    GuideWindow& showGuide(const QString& page);  ///< a name of listGuidePages()

private:
    [[nodiscard]] QString pageOfFocus() const;
    void showAbout();

    OpeningActions& opening_;
    QSettings& settings_;
    QMainWindow& window_;
    QPointer<GuideWindow> shown_;
    QAction* guide_;
    QAction* start_;
    QAction* about_;
};

}  // namespace noonmark
