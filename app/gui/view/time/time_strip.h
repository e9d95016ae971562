#pragma once

// Sun and time. TimeStrip below the view has the sliders and plays the sun; ShownTime is the value that they
// choose, SunAtMoment the sun there, and play and keys move it. At one moment SunShadow draws the
// shadow on everything; of a study's day or moment MomentPreview computes the shadow on its cells from cached
// horizons, fast enough to follow a slider. TimeDisplay shows both; DomeDisplay shows the sun path dome.

#include <QElapsedTimer>
#include <QWidget>

#include "app/gui/view/time/sun_at_moment.h"

class QComboBox;
class QLineEdit;
class QGridLayout;
class QLabel;
class QPushButton;
class QTimer;
class QToolButton;

namespace noonmark {

class MarkedSlider;

/// The strip below the view: date and time with sunrise, sunset, solstices and equinoxes, play, and the part
/// of time that is shown. Dates are in the year in which the period begins.
class TimeStrip final : public QWidget {
    Q_OBJECT
public:
    explicit TimeStrip(QWidget* parent = nullptr);

    /// Sets the period; the shown time stays if the year is the same.
    void setPeriod(const Period& period);
    [[nodiscard]] const ShownTime& look() const { return look_; }
    void setLook(const ShownTime& look);  ///< the date must be in the year of the period
    /// Shows a time as if it had been chosen in the strip; the day in the year of the period.
    void choose(ShownTime look);
    /// Whether a whole day can be shown: only of a study.
    void setDayOffered(bool offered);
    /// The sun at look().
    void setSun(const SunAtMoment& sun);
    /// The result text of a time that was computed, such as "71 % in shadow".
    void setAnswer(const ShownTime& of, const QString& words);

    void move(int minutes, int days);  ///< later, or earlier if below 0; shows that moment
    void setPlaying(bool playing);
    [[nodiscard]] bool playing() const;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

Q_SIGNALS:
    void lookChanged(noonmark::ShownTime look);
    void taken(noonmark::ShownTime look);  ///< to become the period of the study

private:
    void makeFields();
    void makePlayer();
    void place();
    void connectFields();
    void take(const ShownTime& look);
    void takeMoment(ShownTime look);
    void step();
    void showLook();
    void showMarks();

    QComboBox* span_;
    MarkedSlider* date_;  // days since the first of the year
    MarkedSlider* time_;  // minutes since midnight
    QLineEdit* dateField_;
    QLineEdit* timeField_;
    QLabel* words_;
    QLabel* sunWords_;
    QPushButton* use_;
    QToolButton* play_;
    QComboBox* loop_;
    QComboBox* speed_;
    QTimer* ticks_;
    QElapsedTimer sinceStep_;
    ShownTime look_;
    SunAtMoment sun_;
};

}  // namespace noonmark
