#pragma once

#include <QAction>
#include <QFrame>
#include <QObject>
#include <QPointer>
#include <QRect>
#include <QTimer>
#include <QWidget>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

class QLabel;
class QMainWindow;
class QPushButton;
class QAction;

namespace noonmark {

// Guided tours. This file has the steps as data and decides when a step is done. Tour walks through the steps
// of one tour, TourControl finds and uses the control of a step in the window, TourBubble shows the text
// beside it.

/// What the user does in a step, and "Show me" does for them.
enum class TourTask {
    none,     ///< only reads
    show,     ///< brings a dock to the front
    click,    ///< a button
    choose,   ///< an entry of a list: by its data, else by its index
    set,      ///< a number
    trigger,  ///< an entry of a menu
    draw,     ///< a polygon on the ground
};

/// When the step is done.
enum class TourGoal {
    task,  ///< as soon as the user has done it
    tower,
    study,
    comparison,
    score,
    place,
    review,  ///< when the window has a new one
};

struct TourStep {
    const char* control;  ///< object name of the widget, dock or action
    TourTask task;
    const char* value;  ///< of choose and set; otherwise null
    TourGoal goal;
    const char* text;  ///< English, in the translation context "Tour"
};

struct TourPlan {
    const char* key;  ///< "architect"
    const char* title;
    const char* about;
    std::vector<TourStep> steps;
};

/// One for each user: architect, planner, review board. All start from the sample Central Park South.
std::span<const TourPlan> listTours();

class ReviewSession;
class Workbench;

/// What the window has at one moment: compared, it shows what is new since a step began.
struct TourSnapshot {
    const void* study = nullptr;
    const void* comparison = nullptr;
    const void* score = nullptr;
    const void* review = nullptr;
    std::size_t places = 0;
    std::size_t edits = 0;  ///< of all scenarios
};

TourSnapshot takeTourSnapshot(Workbench& workbench, ReviewSession& review);

/// Whether the window has something new of that kind. Never for TourGoal::task.
bool isReached(TourGoal goal, const TourSnapshot& before, const TourSnapshot& now);

/// A frame around the control of a step. The mouse goes through it.
class TourFrame final : public QWidget {
    Q_OBJECT
public:
    explicit TourFrame(QWidget* parent);

    void put(const QRect& control);  ///< in the parent; empty: hides it

protected:
    void paintEvent(QPaintEvent* event) override;
};

/// The text of a step beside its control, above the 3D view too: a window of its own without a frame.
class TourBubble final : public QFrame {
    Q_OBJECT
public:
    explicit TourBubble(QMainWindow& window);

    /// What the button does that leads on.
    enum class NextButton { showMe, next, finish };
    void present(const QString& title, const QString& text, NextButton nextButton);
    void put(const QRect& control);  ///< beside it, in the window; empty: in the middle

Q_SIGNALS:
    void showMe();
    void ended();

private:
    QMainWindow& window_;
    QLabel* title_;
    QLabel* text_;
    QPushButton* show_;
    QPushButton* end_;
};

/// The control of a step in the window: where it is, and what the user or "Show me" does with it.
class TourControl final : public QObject {
    Q_OBJECT
public:
    /// `draw` draws the polygon of TourTask::draw. `window` must outlive it.
    TourControl(QMainWindow& window, const TourStep& step, std::function<void()> draw);

    [[nodiscard]] bool found() const { return widget_ != nullptr || action_ != nullptr; }
    [[nodiscard]] QRect area() const;  ///< in the window; of a closed dock the menu that opens it
    void reveal();                     ///< brings its dock to the front and scrolls to it
    void showMe();                     ///< does what the step asks for, as the user would

Q_SIGNALS:
    void done();  ///< by the user or by showMe(); queued, so that the window has answered

private:
    void watch();
    void watchList();
    void choose();
    void set();
    [[nodiscard]] QRect areaOf(const QAction& action) const;

    QMainWindow& window_;
    TourStep step_;
    std::function<void()> draw_;
    QPointer<QWidget> widget_;
    QPointer<QAction> action_;
};

class ViewPanel;

/// What a tour needs of the window. All must outlive the tour.
struct TourStage {
    QMainWindow& window;
    Workbench& workbench;
    ReviewSession& review;
    ViewPanel& panel;
};

/// Walks through the steps of a plan: frames the real control, states what it is for, and goes on when the
/// user has used it, or when "Show me" did.
class Tour final : public QObject {
    Q_OBJECT
public:
    Tour(const TourPlan& plan, TourStage stage, QObject* parent = nullptr);
    ~Tour() override;

    void start();
    void showMe();  ///< nothing while the goal of the step is being computed
    void end();

    [[nodiscard]] std::size_t step() const { return step_; }
    [[nodiscard]] std::size_t steps() const { return plan_.steps.size(); }

Q_SIGNALS:
    void ended();

private:
    void enter(std::size_t step);
    void follow();
    void takeDone();
    void drawPlace();
    [[nodiscard]] bool isLast() const { return step_ + 1 == plan_.steps.size(); }
    [[nodiscard]] TourBubble::NextButton nextButton() const;
    [[nodiscard]] const TourStep& current() const { return plan_.steps[step_]; }

    const TourPlan& plan_;
    TourStage stage_;
    TourBubble* bubble_;
    TourFrame* frame_;
    std::unique_ptr<TourControl> control_;
    TourSnapshot before_;
    QTimer watch_;
    std::size_t step_ = 0;
};

class OpeningActions;

/// The guided tours of the menu Help. Each opens the sample Central Park South first, and asks before if
/// there is unsaved work.
class TourActions final : public QObject {
    Q_OBJECT
public:
    TourActions(OpeningActions& opening, TourStage stage);

    [[nodiscard]] QList<QAction*> actions() const { return actions_; }
    void start(std::size_t tour);                          ///< an index of listTours()
    [[nodiscard]] Tour* running() const { return tour_; }  ///< null: none

private:
    void begin(std::size_t tour);

    OpeningActions& opening_;
    TourStage stage_;
    QList<QAction*> actions_;
    QPointer<Tour> tour_;
    QMetaObject::Connection waiting_;
};

/// Its title or description in the language of the window.
QString titleOf(const TourPlan& plan);
QString aboutOf(const TourPlan& plan);

}  // namespace noonmark
