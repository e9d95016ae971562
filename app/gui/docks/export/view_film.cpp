#include "app/gui/docks/export/view_film.h"

#include "app/gui/view/panel/time_display.h"
#include "app/gui/view/time/time_strip.h"
#include "core/io/files/pending_file.h"

namespace noonmark {

ViewFilm::ViewFilm(ViewPanel& panel, TimeDisplay& time, QObject* parent)
    : QObject(parent), panel_(panel), time_(time) {}

// The strip shows one moment, so that the view does.
void ViewFilm::begin(const FilmedView& film) {
    if (!film_) look_ = panel_.time().look();
    film_ = film;
    pose_ = panel_.view().pose();
    panel_.time().setPlaying(false);
    TimeLook look = look_;
    look.span = LookSpan::moment;
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

}  // namespace noonmark
