#include "app/report/movie/shadow_movie.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "app/report/book/diagram.h"
#include "app/report/book/paper.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/study_text.h"
#include "core/base/progress.h"
#include "core/city/trees/tree.h"
#include "core/describe/text.h"
#include "core/io/files/write_text.h"
#include "core/measures/shadow_outlines.h"
#include "core/receivers/place_names.h"
#include "core/study/review_study.h"

namespace noonmark {

namespace {

constexpr double heightPt = 500;  // of a frame: all text scales with it
constexpr double frameMarginPt = 10, movieTitlePt = 24;
constexpr double longestShadowM = 500;   // that decides what is shown; the shadows themselves go on
constexpr std::size_t timesAtOnce = 16;  // outlines of a year are not held together
constexpr std::size_t swipeFrames = 48, restFrames = 8;

std::shared_ptr<const DiagramScene> makeScene(const ShadowMovie& movie, bool withScenario) {
    DiagramScene scene;
    // Hundreds of plantings without a name would cover the map.
    std::ranges::copy_if(movie.places, std::back_inserter(scene.places), hasOwnName);
    if (!withScenario || !movie.scenario) {
        scene.city = *movie.baseline;
        return std::make_shared<const DiagramScene>(std::move(scene));
    }
    scene.proposal = keepOwnBuildings(*movie.scenario, *movie.baseline);
    scene.removed = keepOwnBuildings(*movie.baseline, *movie.scenario);
    scene.city = keepOwnBuildings(*movie.scenario, scene.proposal);
    return std::make_shared<const DiagramScene>(std::move(scene));
}

/// "2026-03-21 11:00" of "2026-03-21 11:00 America/New_York".
QString shortTime(const DrawnTime& time) { return plainText(time.clock).section(u' ', 0, 1); }

QString sunText(const SunStep& sun) {
    return sheetText("Sun: azimuth %1°, altitude %2°")
        .arg(describeAmount(double(sun.azimuthDeg), 1), describeAmount(double(sun.altitudeDeg), 1));
}

/// The whole frame and the part with the diagram, in points.
struct FrameLayout {
    QRectF frame, diagram;
};

FrameLayout layOut(const MovieFormat& format) {
    const QRectF frame(0, 0, format.size.width() * heightPt / format.size.height(), heightPt);
    return {frame, frame.adjusted(frameMarginPt, frameMarginPt + movieTitlePt, -frameMarginPt,
                                  -frameMarginPt - diagramFootPt(1))};
}

/// The area, widened to the proportions of the map in a frame: shadows are computed for all that is seen.
Box2 widenToFrame(const Box2& area, const MovieFormat& format) {
    const QRectF map = mapAreaOf(layOut(format).diagram, 1);
    const glm::dvec2 size(area.high - area.low), centre = glm::dvec2(area.low + area.high) / 2.0;
    const double scale =
        std::max(size.x / map.width(), size.y / map.height()) * pointsPerMetre(1);  // of 1:scale
    return groundOf(centre, scale, map);
}

/// Paints frames of one scene at one scale; `area` has the proportions of the map.
class FramePainter {
public:
    FramePainter(const ShadowMovie& movie, std::shared_ptr<const DiagramScene> scene, const Box2& area)
        : movie_(movie), scene_(std::move(scene)), centre_(glm::dvec2(area.low + area.high) / 2.0) {
        const FrameLayout layout = layOut(movie.format);
        frame_ = layout.frame;
        area_ = layout.diagram;
        scale_ = double(area.high.x - area.low.x) / mapAreaOf(area_, 1).width() * pointsPerMetre(1);
    }

    [[nodiscard]] QImage paint(const DrawnTime& time, const ShadowOutlines& shadows) const {
        QImage image(movie_.format.size, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(image.height() / heightPt, image.height() / heightPt);
        const Canvas canvas{painter, 1};
        paintTitle(canvas, time);
        Diagram diagram{scene_, shadows, {}, {}, centre_, scale_, {}, 1};
        diagram.caption = {plainText(time.clock), sunText(time.sun)};
        paintDiagram(canvas, area_, diagram);
        paintDiagramFoot(canvas, {area_.left(), area_.bottom(), area_.width(), diagramFootPt(1)},
                         {scale_, {}, plainText(movie_.credit), 1, DiagramFoot::Subject::shadows});
        return image;
    }

private:
    void paintTitle(const Canvas& canvas, const DrawnTime& time) const {
        const QRectF line(frame_.left() + frameMarginPt, frameMarginPt / 2,
                          frame_.width() - 2 * frameMarginPt, movieTitlePt);
        const double timeWidth = 150;
        paintFitted(canvas, line.adjusted(0, 0, -timeWidth, 0), plainText(movie_.title), 14, 8, QFont::Bold,
                    ink::heading);
        paintFitted(canvas, line.adjusted(line.width() - timeWidth, 0, 0, 0), shortTime(time), 14, 7,
                    QFont::Bold, ink::text, Qt::AlignRight);
    }

    const ShadowMovie& movie_;
    std::shared_ptr<const DiagramScene> scene_;
    glm::dvec2 centre_;
    QRectF frame_, area_;  // points
    double scale_ = 1;
};

/// `share` of the width, from the left, shows `uncovered`.
QImage composeSwipe(const QImage& covered, const QImage& uncovered, double share) {
    QImage image = covered;
    const int x = int(std::lround(share * image.width()));
    QPainter painter(&image);
    painter.drawImage(QRect(0, 0, x, image.height()), uncovered, QRect(0, 0, x, image.height()));
    if (x > 0 && x < image.width()) painter.fillRect(x - 1, 0, 3, image.height(), ink::text);
    return image;
}

/// The area that all frames show: as of a drawing of all times.
Result<Box2> findArea(const ShadowMovie& movie, const std::vector<DrawnTime>& times,
                      const std::stop_token& stop) {
    if (movie.drawing.area) return *movie.drawing.area;
    // The first and the last times have the longest shadows of a day, those around noon the shortest.
    const std::vector<DrawnTime> some{times.front(), times[times.size() / 2], times.back()};
    DrawingSettings settings = movie.drawing;
    settings.withFans = false;
    settings.longestM = std::min(settings.longestM, longestShadowM);
    NoProgress quiet;
    return drawShadows(*movie.baseline, movie.scenario.get(), movie.places, some, settings, quiet, stop)
        .map([](const ShadowDrawing& drawing) { return drawing.area; });
}

class Filming {
public:
    Filming(const ShadowMovie& movie, std::span<const DrawnTime> times, MovieWriter& writer, const Box2& area,
            Progress& progress, const std::stop_token& stop)
        : movie_(movie), times_(times), writer_(writer), area_(area), progress_(progress), stop_(stop) {}

    Result<std::size_t> run() {
        if (auto done = movie_.swipe ? filmSwipe() : filmTimes(); !done)
            return tl::make_unexpected(done.error());
        return frames_;
    }

private:
    Result<std::vector<ShadowOutlines>> outlinesOf(std::span<const DrawnTime> times) {
        std::vector<SunStep> steps;
        for (const DrawnTime& time : times) steps.push_back(time.sun);
        NoProgress quiet;
        return outlineShadows(*movie_.baseline, movie_.scenario.get(), steps, {area_, movie_.drawing.cellM},
                              quiet, stop_);
    }

    Result<void> add(const QImage& frame) {
        ++frames_;
        return writer_.add(frame);
    }

    Result<void> filmTimes() {
        const FramePainter painter(movie_, makeScene(movie_, true), area_);
        for (std::size_t first = 0; first < times_.size(); first += timesAtOnce) {
            const auto times = times_.subspan(first, std::min(timesAtOnce, times_.size() - first));
            progress_.report(double(first) / double(times_.size()),
                             NM_TEXT("computing the frames of the movie"));
            const auto outlines = outlinesOf(times);
            if (!outlines) return tl::make_unexpected(outlines.error());
            for (std::size_t i = 0; i < times.size(); ++i) {
                if (stop_.stop_requested()) return cancelled();
                if (auto added = add(painter.paint(times[i], (*outlines)[i])); !added) return added;
            }
        }
        return {};
    }

    Result<void> filmSwipe() {
        const auto outlines = outlinesOf(times_.first(1));
        if (!outlines) return tl::make_unexpected(outlines.error());
        const DrawnTime& time = times_.front();
        const QImage after =
            FramePainter(movie_, makeScene(movie_, true), area_).paint(time, outlines->front());
        const QImage before = FramePainter(movie_, makeScene(movie_, false), area_)
                                  .paint(time, {outlines->front().baseline, {}, {}, outlines->front().cellM});
        for (std::size_t i = 0; i < swipeFrames + 2 * restFrames; ++i) {
            if (stop_.stop_requested()) return cancelled();
            const double share = (double(i) - double(restFrames)) / double(swipeFrames - 1);
            if (auto added = add(composeSwipe(before, after, std::clamp(share, 0.0, 1.0))); !added)
                return added;
            progress_.report(double(i) / double(swipeFrames), NM_TEXT("writing the movie"));
        }
        return {};
    }

    const ShadowMovie& movie_;
    std::span<const DrawnTime> times_;
    MovieWriter& writer_;
    Box2 area_;
    Progress& progress_;
    const std::stop_token& stop_;
    std::size_t frames_ = 0;
};

}  // namespace

Result<MovieFacts> writeShadowMovie(const ShadowMovie& movie, const std::filesystem::path& file,
                                    Progress& progress, const std::stop_token& stop) {
    if (const auto may = checkOutput(file, OutputKind::movie, movie.outputs); !may)
        return tl::make_unexpected(may.error());
    if (movie.swipe && !movie.scenario)
        return failure("A swipe needs a baseline and a scenario", "swipe", "Name the scenario");
    Warnings warnings;
    const auto times = listDrawnTimes(movie.when, *movie.baseline, warnings);
    if (!times) return tl::make_unexpected(times.error());
    std::ranges::move(warnOfTrees((movie.scenario ? movie.scenario : movie.baseline)->trees),
                      std::back_inserter(warnings));
    const auto wanted = findArea(movie, *times, stop);
    if (!wanted) return tl::make_unexpected(wanted.error());
    const Box2 area = widenToFrame(*wanted, movie.format);
    PendingFile pending(file);
    auto writer = MovieWriter::create(pending.path(), movie.format);
    if (!writer) return tl::make_unexpected(writer.error());
    const auto frames = Filming(movie, *times, *writer, area, progress, stop).run();
    if (!frames) return tl::make_unexpected(frames.error());
    if (auto done = writer->finish(); !done) return tl::make_unexpected(done.error());
    if (auto done = pending.commit(); !done) return tl::make_unexpected(done.error());
    return MovieFacts{*frames, double(*frames) / movie.format.framesPerSecond, area, std::move(warnings)};
}

}  // namespace noonmark
