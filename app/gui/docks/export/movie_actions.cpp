#include "app/gui/docks/export/movie_actions.h"

#include <QProgressDialog>
#include <QSignalBlocker>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/time_display.h"
#include "app/gui/view/time/time_strip.h"
#include "core/base/warnings.h"
#include "core/io/files/write_text.h"

namespace noonmark {

ViewFilm::ViewFilm(ViewPanel& panel, TimeDisplay& time, QObject* parent)
    : QObject(parent), panel_(panel), time_(time) {}

// The strip shows one moment, so that the view does.
void ViewFilm::begin(const FilmedView& film) {
    if (!film_) look_ = panel_.time().look();
    film_ = film;
    pose_ = panel_.view().pose();
    panel_.time().setPlaying(false);
    ShownTime look = look_;
    look.span = ShownSpan::moment;
    panel_.time().choose(look);
}

void ViewFilm::end() {
    if (!film_) return;
    film_.reset();
    panel_.endPictures();
    panel_.time().choose(look_);
    time_.showStripSun();
}

void ViewFilm::draw(std::size_t index) {
    if (!film_) return;
    if (panel_.view().pose() != pose_) panel_.view().setPose(pose_);
    const DrawnTime& time = film_->times[index];
    time_.showSunFrom(glm::dvec3(time.sun.direction), [this, time] {
        if (!film_) return;
        PictureFrame frame = panel_.pictureFrame(film_->title, QString::fromStdString(time.clock));
        panel_.takePicture({frame, film_->format.size, true, false, true},
                           [this](QImage image) { put(std::move(image)); });
    });
}

void ViewFilm::put(QImage frame) {
    {
        const std::scoped_lock lock(mutex_);
        frame_ = std::move(frame);
    }
    drawn_.notify_one();
}

Result<QImage> ViewFilm::takeFrame(std::size_t index, const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    frame_ = {};
    QMetaObject::invokeMethod(
        this, [this, index] { draw(index); }, Qt::QueuedConnection);
    if (!drawn_.wait(lock, stop, [this] { return !frame_.isNull(); })) return cancelled();
    return frame_;
}

Result<MovieFacts> writeViewMovie(
    const FilmedView& film, const std::filesystem::path& file,
    const std::function<Result<QImage>(std::size_t index, const std::stop_token& stop)>& takeFrame,
    Progress& progress, const std::stop_token& stop) {
    if (const auto may = checkOutput(file, OutputKind::movie, film.outputs); !may)
        return tl::make_unexpected(may.error());
    PendingFile pending(file);
    auto writer = MovieWriter::create(pending.path(), film.format);
    if (!writer) return tl::make_unexpected(writer.error());
    for (std::size_t i = 0; i < film.times.size(); ++i) {
        progress.report(double(i) / double(film.times.size()), "drawing the frames of the movie");
        const auto frame = takeFrame(i, stop);
        if (!frame) return tl::make_unexpected(frame.error());
        if (auto added = writer->add(*frame); !added) return tl::make_unexpected(added.error());
    }
    if (auto done = writer->finish(); !done) return tl::make_unexpected(done.error());
    if (auto done = pending.commit(); !done) return tl::make_unexpected(done.error());
    const std::size_t frames = film.times.size();
    return MovieFacts{frames, double(frames) / film.format.framesPerSecond, {}, film.warnings};
}

MovieActions::MovieActions(Workbench& workbench, ViewPanel& panel, TimeDisplay& time, QWidget& window)
    : workbench_(workbench),
      panel_(panel),
      window_(window),
      export_(makeAction(this, tr("Export &movie..."), QKeySequence(tr("Ctrl+Shift+E")),
                         tr("The shadows of a day, of a year, or of the change by a scenario, as MP4 or "
                            "GIF"),
                         "movie")),
      film_(panel, time, this) {
    connect(export_, &QAction::triggered, this, &MovieActions::ask);
}

void MovieActions::ask() {
    if (!workbench_.city()) return panel_.messages().showError(noCityError());
    auto* dialog = new MovieDialog(firstChoice(), workbench_.comparing(),
                                   workbench_.document().settings().period.days, &window_);
    connect(dialog, &MovieDialog::chosen, this, [this](const MovieChoice& choice) {
        const QString file = askForMovie(&window_, workbench_.projectName());
        if (!file.isEmpty()) writeTo(file, choice);
    });
    syncMoment(*dialog);
    dialog->open();
}

// The view shows the moment that is chosen for the movie, and the movie follows the strip below the view.
void MovieActions::syncMoment(MovieDialog& dialog) {
    TimeStrip& strip = panel_.time();
    connect(&dialog, &MovieDialog::momentChosen, &strip, [&dialog, &strip] {
        const MovieChoice choice = dialog.choice();
        const QSignalBlocker quiet(dialog);
        strip.choose({ShownSpan::moment, choice.date, choice.at});
    });
    connect(&strip, &TimeStrip::lookChanged, &dialog, [&dialog](const ShownTime& look) {
        if (!dialog.signalsBlocked()) dialog.setMoment(look.date, look.at);
    });
}

// The date and time of the strip below the view.
MovieChoice MovieActions::firstChoice() const {
    const ShownTime& look = panel_.time().look();
    MovieChoice first;
    first.date = look.date;
    first.at = look.at;
    const ProjectSession& session = workbench_.session();
    const QString scenario = scenarioName(session.scenario());
    const QString title = workbench_.comparing()
                              ? tr("%1 compared with %2").arg(scenario, scenarioName(session.baseline()))
                              : tr("Shadow: %1").arg(scenario);
    first.title = title.toStdString();
    return first;
}

DrawnTimeChoice MovieActions::timesOf(const MovieChoice& choice) const {
    using Kind = MovieChoice::Kind;
    const Period& period = workbench_.document().settings().period;
    DrawnTimeChoice when{.zone = period.zone};
    if (choice.kind == Kind::year) when.days = listDaysOf(int(choice.date.year()));
    if (choice.kind == Kind::day || choice.kind == Kind::swipe) when.days = {formatText(choice.date)};
    for (int day = 0; choice.kind == Kind::period && day < period.days; ++day)
        when.days.push_back(
            formatText(CivilDate(std::chrono::sys_days(period.start) + std::chrono::days(day))));
    if (choice.kind == Kind::day)
        when.everyMin = choice.everyMin;
    else
        when.times = {formatText(choice.at)};
    return when;
}

Result<ShadowMovie> MovieActions::movieOf(const MovieChoice& choice) {
    ProjectSession& session = workbench_.session();
    const StudySettings& settings = workbench_.document().settings();
    ShadowMovie movie{.baseline = session.city(),
                      .places = session.project().places,
                      .when = timesOf(choice),
                      .title = choice.title,
                      .credit = session.project().attribution,
                      .swipe = choice.kind == MovieChoice::Kind::swipe,
                      .format = choice.format,
                      .outputs = workbench_.exportRules()};
    if (choice.area == MovieChoice::Area::region) movie.drawing.area = bounds(settings.region);
    if (choice.area == MovieChoice::Area::view) movie.drawing.area = bounds(panel_.visibleGround());
    if (!workbench_.comparing()) return movie;
    const auto baseline = session.cityOf(session.baseline());
    if (!baseline) return tl::make_unexpected(baseline.error());
    movie.scenario = std::exchange(movie.baseline, *baseline);
    return movie;
}

void MovieActions::writeTo(const QString& file, const MovieChoice& choice) {
    if (choice.area == MovieChoice::Area::camera) return filmView(file, choice);
    auto movie = movieOf(choice);
    if (!movie) return panel_.messages().showError(movie.error());
    writing_.start<MovieFacts>(
        tr("Movie"),
        [movie = *std::move(movie), file](Progress& progress, const std::stop_token& stop) {
            return writeShadowMovie(movie, file.toStdString(), progress, stop);
        },
        [this, file](const Result<MovieFacts>& facts) { finish(facts, file); });
}

void MovieActions::filmView(const QString& file, const MovieChoice& choice) {
    FilmedView film{.title = QString::fromStdString(choice.title),
                    .format = choice.format,
                    .outputs = workbench_.exportRules()};
    auto times = listDrawnTimes(timesOf(choice), *workbench_.session().city(), film.warnings);
    if (!times) return panel_.messages().showError(times.error());
    film.times = *std::move(times);
    film_.begin(film);
    writing_.start<MovieFacts>(
        tr("Movie"),
        [this, film, file](Progress& progress, const std::stop_token& stop) {
            const auto take = [this](std::size_t index, const std::stop_token& asked) {
                return film_.takeFrame(index, asked);
            };
            return writeViewMovie(film, file.toStdString(), take, progress, stop);
        },
        [this, file](const Result<MovieFacts>& facts) {
            film_.end();
            finish(facts, file);
        });
    askToStop();
}

// The window is what is filmed: it can be stopped, not changed.
void MovieActions::askToStop() {
    auto* asking = new QProgressDialog(tr("Filming the view"), tr("Stop"), 0, 0, &window_);
    asking->setAttribute(Qt::WA_DeleteOnClose);
    asking->setWindowModality(Qt::WindowModal);
    asking->setMinimumDuration(0);
    connect(asking, &QProgressDialog::canceled, &writing_, &JobSlot::cancel);
    connect(&writing_, &JobSlot::ended, asking, &QWidget::close);
    asking->show();
}

void MovieActions::finish(const Result<MovieFacts>& facts, const QString& file) {
    if (facts) return showSaved(*facts, file);
    if (!isCancelled(facts.error())) panel_.messages().showError(facts.error());
}

// Times without a frame are listed below the number of frames.
void MovieActions::showSaved(const MovieFacts& facts, const QString& file) {
    QStringList lines{tr("Movie of %1 frame(s) saved as %2", "", pluralNumber(quint64(facts.frames)))
                          .arg(formatCount(quint64(facts.frames)), file)};
    for (const WarningGroup& group : groupWarnings(facts.warnings)) lines << describeWarningWithPlaces(group);
    panel_.messages().showNote(lines.join(u'\n'));
}

}  // namespace noonmark
