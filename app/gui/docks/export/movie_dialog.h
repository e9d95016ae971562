#pragma once

#include <QDialog>

#include "app/report/movie/movie_writer.h"
#include "core/sun/civil_time.h"

class QComboBox;
class QDateEdit;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;
class QTimeEdit;

namespace noonmark {

/// What a movie from the window shows.
struct MovieChoice {
    enum class Kind {
        day,     ///< one day, as long as the sun is up
        year,    ///< every day of a year, at one time
        period,  ///< every day of the study's period, at one time
        swipe,   ///< at one moment, a line uncovers the scenario
    };
    enum class Area {
        automatic,  ///< see DrawingSettings::area
        region,     ///< of the study
        view,       ///< the ground that the view shows
        camera,     ///< the view itself, in 3D, from where its camera stands
    };
    Kind kind = Kind::day;
    Area area = Area::automatic;
    CivilDate date{std::chrono::year{2026}, std::chrono::March, std::chrono::day{21}};
    std::chrono::minutes at{12 * 60};  ///< of a year and a swipe
    int everyMin = 10;                 ///< of a day, 1 to 720
    MovieFormat format;
    std::string title;
};

/// Asks what a movie shows: a day, a year, or the change by a scenario. Not modal.
class MovieDialog final : public QDialog {
    Q_OBJECT
public:
    /// `first`: what the fields begin with. `comparing`: a swipe is offered, too. `days`: of the period.
    MovieDialog(const MovieChoice& first, bool comparing, int days, QWidget* parent);

    [[nodiscard]] MovieChoice choice() const;
    /// Shows another date and time, as they were chosen elsewhere; the year stays.
    void setMoment(CivilDate date, std::chrono::minutes at);

Q_SIGNALS:
    void chosen(noonmark::MovieChoice choice);
    void momentChosen();  ///< the user chose another date or time: those of choice()

private:
    void makeTimes(QFormLayout& form, const MovieChoice& first, bool comparing, int days);
    void makePicture(QFormLayout& form, const MovieChoice& first);
    void makeButtons(QFormLayout& form);
    void update();

    QComboBox* kind_;
    QDateEdit* date_;
    QTimeEdit* at_;
    QSpinBox* every_;
    QComboBox* area_;
    QComboBox* size_;
    QSpinBox* rate_;
    QLineEdit* title_;
    QLabel* length_;
};

}  // namespace noonmark
