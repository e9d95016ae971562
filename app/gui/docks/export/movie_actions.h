#pragma once

#include <QDialog>
#include <QObject>
#include <QPointer>
#include <condition_variable>
#include <mutex>
#include <stop_token>

#include "app/gui/base/jobs/job.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/panel/view_picture.h"
#include "app/report/movie/movie_writer.h"
#include "app/report/movie/shadow_movie.h"
#include "core/sun/civil_time.h"

class QComboBox;
class QDateEdit;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;
class QTimeEdit;
class QAction;
class QWidget;

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

class TimeDisplay;

/// What a movie of the view shows: the city from where its camera stands, moment after moment.
struct FilmedView {
    std::vector<DrawnTime> times;  ///< one frame each
    QString title;
    MovieFormat format;
    Warnings warnings;  ///< of listDrawnTimes()
    OutputRules outputs;
};

/// Draws the frames of a movie of the view, one at a time, as a job asks for them. Meanwhile the window keeps
/// what it showed; end() gives camera and sun back to it.
class ViewFilm final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    ViewFilm(ViewPanel& panel, TimeDisplay& time, QObject* parent);

    void begin(const FilmedView& film);
    void end();

    /// A frame, for the job. Waits until it is drawn. Error: cancelled().
    Result<QImage> takeFrame(std::size_t index, const std::stop_token& stop);

private:
    void draw(std::size_t index);
    void put(QImage frame);

    ViewPanel& panel_;
    TimeDisplay& time_;
    std::optional<FilmedView> film_;  // empty: nothing is filmed
    CameraPose pose_;
    ShownTime look_;  // of the strip before
    std::mutex mutex_;
    std::condition_variable_any drawn_;
    QImage frame_;  // guarded by mutex_; null: not drawn yet
};

/// Writes a movie of what takeFrame gives; the file appears when it is complete. For a job. Errors of
/// checkOutput(), MovieWriter and takeFrame.
Result<MovieFacts> writeViewMovie(
    const FilmedView& film, const std::filesystem::path& file,
    const std::function<Result<QImage>(std::size_t index, const std::stop_token& stop)>& takeFrame,
    Progress& progress, const std::stop_token& stop);

class ViewPanel;
class Workbench;

/// Writes the movies of `noonmark-cli project animate` of the displayed scenario, and of its difference from
/// the baseline where one is chosen; and movies of the view itself.
class MovieActions final : public QObject {
    Q_OBJECT
public:
    /// Dialogs belong to `window`. All must outlive this object.
    MovieActions(Workbench& workbench, ViewPanel& panel, TimeDisplay& time, QWidget& window);

    [[nodiscard]] QAction* action() const { return export_; }
    [[nodiscard]] JobSlot& writing() { return writing_; }

    /// Writes a movie; MP4 or GIF by the file extension. An existing movie is replaced.
    void writeTo(const QString& file, const MovieChoice& choice);

private:
    void ask();
    [[nodiscard]] MovieChoice firstChoice() const;
    void syncMoment(MovieDialog& dialog);
    [[nodiscard]] DrawnTimeChoice timesOf(const MovieChoice& choice) const;
    void filmView(const QString& file, const MovieChoice& choice);
    void askToStop();
    void finish(const Result<MovieFacts>& facts, const QString& file);
    [[nodiscard]] Result<ShadowMovie> movieOf(const MovieChoice& choice);
    void showSaved(const MovieFacts& facts, const QString& file);

    Workbench& workbench_;
    ViewPanel& panel_;
    QWidget& window_;
    QAction* export_;
    ViewFilm film_;
    JobSlot writing_;
};

}  // namespace noonmark
