#pragma once

#include <QObject>
#include <QPointer>
#include <condition_variable>
#include <mutex>
#include <stop_token>

#include "app/gui/base/jobs/job.h"
#include "app/gui/docks/export/movie_dialog.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/panel/view_picture.h"
#include "app/report/movie/shadow_movie.h"

class QAction;
class QWidget;

namespace noonmark {

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
    TimeLook look_;  // of the strip before
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
    void moveTogether(MovieDialog& dialog);
    [[nodiscard]] DrawnTimeChoice timesOf(const MovieChoice& choice) const;
    void filmView(const QString& file, const MovieChoice& choice);
    void askToStop();
    void finish(const Result<MovieFacts>& facts, const QString& file);
    [[nodiscard]] Result<ShadowMovie> movieOf(const MovieChoice& choice);
    void tellSaved(const MovieFacts& facts, const QString& file);

    Workbench& workbench_;
    ViewPanel& panel_;
    QWidget& window_;
    QAction* export_;
    ViewFilm film_;
    JobSlot writing_;
};

}  // namespace noonmark
