#pragma once

#include <QObject>

#include "app/gui/base/jobs/job_slot.h"
#include "app/gui/docks/export/movie_dialog.h"
#include "app/gui/docks/export/view_film.h"
#include "app/report/movie/shadow_movie.h"

class QAction;
class QWidget;

namespace noonmark {

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
