#pragma once

#include <QDialog>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QTableWidget>
#include <functional>

#include "app/gui/frame/help/guide_window.h"
#include "app/gui/frame/help/start_page.h"

class QWidget;
class QMenuBar;
class QAction;
class QMainWindow;
class QSettings;

namespace noonmark {

/// Whether a widget takes input: a number, a text, a choice, a switch, a slider, a list or a button.
bool isField(const QWidget& widget);

/// The text of "What's this" for a field as HTML: its label, what it means (its tool tip, or a text of its
/// own in field_help.cpp), range and unit, and a link to the guide (guideLink()). Empty where nothing is
/// known.
QString describeField(const QWidget& field);

/// "What's this" for all windows of the application: texts are made when they are asked for, so that fields
/// that come later have theirs too. Shift+F1 explains the focused field; F1 and the links in these texts open
/// the guide, in dialogs too.
class FieldHelp final : public QObject {
    Q_OBJECT
public:
    using ShowGuide = std::function<void(const GuidePlace&)>;
    explicit FieldHelp(ShowGuide showGuide, QObject* parent = nullptr);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool openGuide(const QObject& watched);

    ShowGuide showGuide_;
};

/// Version, build, libraries, instruction set and graphics, as plain text to be copied into a report of a
/// fault.
QString makeAboutText();

/// What keys and mouse do, as a table that can be searched: the shortcuts of all menu entries as they are,
/// and what the mouse does in the view. Not modal.
class KeySheet final : public QDialog {
    Q_OBJECT
public:
    explicit KeySheet(const QMenuBar& menus, QWidget* parent = nullptr);

    [[nodiscard]] const QTableWidget& table() const { return *table_; }  ///< where, what, keys

private:
    void add(const QString& where, const QString& what, const QString& keys);
    void addMenu(const QString& where, const QList<QAction*>& entries);
    void addMouse();
    void filter(const QString& words);

    QTableWidget* table_;
};

class GuideWindow;
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
    [[nodiscard]] QAction* questions() const { return questions_; }  ///< those of the start page, as a menu

    /// What to open, and what to ask. `cityChosen`: the user has a city open, not only the first sample.
    void showStart(bool cityChosen = true);
    void closeStart();  ///< does nothing if it is not shown
    GuideWindow& showGuide(const GuidePlace& place);

Q_SIGNALS:
    void tourRequested(std::size_t tour);  ///< an index of listTours(), from the start page
    /// A card of the start page was chosen, and its city is there.
    void questionAsked(noonmark::StartQuestion question);

private:
    void showAbout();
    void showKeys();
    void listQuestions();
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
    QAction* questions_;
};

}  // namespace noonmark
