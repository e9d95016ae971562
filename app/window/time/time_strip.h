#pragma once

// Display of one day or moment of a study. TimeStrip has the sliders, TimeLook is the value that they choose,
// TimeLooking computes its shadow from cached horizons, fast enough to follow a slider, and TimeDisplay shows
// it.

#include <QWidget>

#include "app/window/time/time_look.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;

namespace noonmark {

/// The strip below the view: sliders that choose a day or moment of the study's year. Dates are in the year
/// in which the study begins.
class TimeStrip final : public QWidget {
    Q_OBJECT
public:
    explicit TimeStrip(QWidget* parent = nullptr);

    /// Sets the period of another study; the look stays if the year is the same.
    void setPeriod(const Period& period);
    [[nodiscard]] const TimeLook& look() const { return look_; }
    void setLook(const TimeLook& look);  ///< the date must be in the year of the study
    /// The result text of a look that was computed, such as "71 % in shadow".
    void setAnswer(const TimeLook& of, const QString& words);

Q_SIGNALS:
    void lookChanged(noonmark::TimeLook look);
    void taken(noonmark::TimeLook look);  ///< to become the period of the study

private:
    void place();
    void connectFields();
    void take();
    void showLook();

    QComboBox* span_;
    QSlider* date_;  // days since the first of the year
    QSlider* time_;  // minutes since midnight
    QLabel* words_;
    QPushButton* use_;
    TimeLook look_;
};

}  // namespace noonmark
