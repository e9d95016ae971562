#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "app/gui/frame/tour/tour_bubble.h"
#include "app/gui/frame/tour/tour_control.h"
#include "app/gui/frame/tour/tour_goal.h"

namespace noonmark {

class ViewPanel;

/// What a tour needs of the window. All must outlive the tour.
struct TourStage {
    QMainWindow& window;
    Workbench& workbench;
    ReviewSession& review;
    ViewPanel& panel;
};

/// Walks through the steps of a plan: frames the real control, tells what it is for, and goes on when the
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
    [[nodiscard]] TourBubble::Onward onward() const;
    [[nodiscard]] const TourStep& current() const { return plan_.steps[step_]; }

    const TourPlan& plan_;
    TourStage stage_;
    TourBubble* bubble_;
    TourFrame* frame_;
    std::unique_ptr<TourControl> control_;
    TourBefore before_;
    QTimer watch_;
    std::size_t step_ = 0;
};

}  // namespace noonmark
