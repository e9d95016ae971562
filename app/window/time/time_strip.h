#pragma once

#include <QWidget>

#include "app/window/time/time_look.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;

namespace noonmark {

/// Below the view of a study: a day or a moment of its year, chosen by sliders that can be dragged. The dates
/// are those of the year in which the study begins.
class TimeStrip final : public QWidget {
    Q_OBJECT
public:
    explicit TimeStrip(QWidget* parent = nullptr);

    /// Another study: the look stays where its year is the same.
    void setPeriod(const Period& period);
    [[nodiscard]] const TimeLook& look() const { return look_; }
    void setLook(const TimeLook& look);  ///< the date lies in the year of the study
    /// What is to be said of a look that was worked out: "71 % in shadow".
    void setAnswer(const TimeLook& of, const QString& words);

Q_SIGNALS:
    void lookChanged(noonmark::TimeLook look);
    void taken(noonmark::TimeLook look);  ///< shall become the period of the study

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
