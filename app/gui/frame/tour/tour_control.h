#pragma once

#include <QAction>
#include <QObject>
#include <QPointer>
#include <QRect>
#include <QWidget>
#include <functional>

#include "app/gui/frame/tour/tour_step.h"

class QMainWindow;

namespace noonmark {

/// The control of a step in the window: where it is, and what the user or "Show me" does with it.
class TourControl final : public QObject {
    Q_OBJECT
public:
    /// `draw` draws the polygon of TourDeed::draw. `window` must outlive it.
    TourControl(QMainWindow& window, const TourStep& step, std::function<void()> draw);

    [[nodiscard]] bool found() const { return widget_ != nullptr || action_ != nullptr; }
    [[nodiscard]] QRect area() const;  ///< in the window; empty while the control is not visible
    void reveal();                     ///< brings its dock to the front and scrolls to it
    void showMe();                     ///< does what the step asks for, as the user would

Q_SIGNALS:
    void done();  ///< by the user or by showMe(); queued, so that the window has answered

private:
    void watch();
    void watchList();
    void choose();
    void set();
    [[nodiscard]] QRect actionArea() const;

    QMainWindow& window_;
    TourStep step_;
    std::function<void()> draw_;
    QPointer<QWidget> widget_;
    QPointer<QAction> action_;
};

}  // namespace noonmark
