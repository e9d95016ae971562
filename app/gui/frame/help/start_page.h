#pragma once

#include <QFrame>
#include <QPointer>
#include <functional>
#include <optional>
#include <span>

#include "app/gui/session/project/recent_files.h"

class QSettings;
class QAbstractButton;
class QDockWidget;
class QLabel;
class QMainWindow;
class QVBoxLayout;

namespace noonmark {

/// Whether the start page is shown when the program starts without a file: at first it is.
bool readShowStart(const QSettings& settings);
void saveShowStart(bool shows, QSettings& settings);

class CardButton;
class ViewPanel;

/// What a user comes with. Each has a card on the start page, and a panel that answers it.
enum class StartQuestion { places, tower, review, facades, score };

/// A card: source texts, to be translated by QCoreApplication::translate("StartQuestion", ...).
struct StartCard {
    StartQuestion question;
    const char* title;
    const char* about;
    const char* icon;
};
std::span<const StartCard> listStartCards();

/// What to begin with, inside the window: on its left what to open (files, recent projects, samples, tours),
/// on its right the questions. The view stays in sight and in use between them. Files may be dropped on it.
/// Closed by Esc or by what it opens; deletes itself then.
class StartPage final : public QFrame {
    Q_OBJECT
public:
    /// `view`: what is left uncovered. `cityChosen`: the user has a city open, of which a question is asked
    /// at once; else a card waits for the city that is opened next.
    StartPage(const RecentFiles& recent, bool cityChosen, QMainWindow& window, ViewPanel& view);
    ~StartPage() override;

    [[nodiscard]] QWidget* questions() const { return questions_; }
    /// The card that waits for a city; nullopt: none.
    [[nodiscard]] std::optional<StartQuestion> waiting() const;

Q_SIGNALS:
    void chosen(QStringList files, noonmark::ReadSettings reading);
    void openRequested();
    void folderRequested();
    void guideRequested();
    void tourRequested(std::size_t tour);  ///< an index of listTours()
    void asked(noonmark::StartQuestion question);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void hidePanelsBelow();
    void showPanelsBelow();
    void makeOpening(const RecentFiles& recent);
    void makeQuestions();
    void addOpenButtons(QVBoxLayout& column);
    void addRecent(QVBoxLayout& column, const RecentFiles& recent);
    void addSamples(QVBoxLayout& column, const RecentFiles& recent);
    void addLinks(QVBoxLayout& column);
    void chooseCard(const CardButton& card, StartQuestion question);
    void place();

    QMainWindow& window_;
    ViewPanel& view_;
    QList<QPointer<QDockWidget>> below_;  ///< panels that are hidden while it is shown
    bool cityChosen_;
    QFrame* questions_;
    QLabel* heading_;
    QList<CardButton*> cards_;
};

}  // namespace noonmark
