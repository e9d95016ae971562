#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QPainter>

#include "app/report/movie/movie_writer.h"
#include "app/report/movie/shadow_movie.h"
#include "core/sun/sun_steps.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

QByteArray bytesOf(const std::filesystem::path& file) {
    QFile opened(QString::fromStdString(file.string()));
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
}

QImage plain(QSize size, QColor colour) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(colour);
    return image;
}

TEST(FrameColours, OfAMapStayAsTheyAre) {
    QImage image = plain({64, 64}, QColor(200, 30, 30));
    QPainter(&image).fillRect(10, 10, 20, 20, QColor(20, 200, 90));
    const QImage reduced = reduceColours(image);
    EXPECT_EQ(reduced.convertToFormat(QImage::Format_RGB32), image);
}

TEST(FrameColours, BeyondTheTableBecomeTheNearest) {
    QImage image({64, 64}, QImage::Format_RGB32);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) image.setPixel(x, y, qRgb(4 * x, 4 * y, (x * y) % 256));
    const QImage reduced = reduceColours(image);
    EXPECT_LE(reduced.colorCount(), 256);
    double sum = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) sum += std::abs(qRed(reduced.pixel(x, y)) - qRed(image.pixel(x, y)));
    EXPECT_LT(sum / (64 * 64), 24);
}

TEST(MovieWriter, RefusesWhatItCannotWrite) {
    const tests::TemporaryFolder folder;
    EXPECT_FALSE(MovieWriter::create(folder.path("movie.avi"), {}));
    EXPECT_FALSE(MovieWriter::create(folder.path("movie.mp4"), {.size = {63, 64}}));
    EXPECT_FALSE(MovieWriter::create(folder.path("movie.mp4"), {.framesPerSecond = 0}));
    EXPECT_FALSE(MovieWriter::create(folder.path("none") / "movie.mp4", {}));
}

TEST(MovieWriter, WritesAGifWithOnePictureAFrame) {
    const tests::TemporaryFolder folder;
    const auto file = folder.path("movie.gif");
    auto writer = MovieWriter::create(file, {.size = {64, 64}, .framesPerSecond = 4});
    ASSERT_TRUE(writer) << writer.error().text();
    for (const Qt::GlobalColor colour : {Qt::red, Qt::green, Qt::blue})
        ASSERT_TRUE(writer->add(plain({64, 64}, colour)));
    ASSERT_TRUE(writer->finish());
    const QByteArray bytes = bytesOf(file);
    EXPECT_TRUE(bytes.startsWith("GIF89a"));
    // A graphic control extension begins each frame: 21 F9 04, flags, and the delay in hundredths of a
    // second.
    EXPECT_EQ(bytes.count(QByteArray::fromHex("21f904")), 3);
    const qsizetype at = bytes.indexOf(QByteArray::fromHex("21f904"));
    EXPECT_EQ(uchar(bytes[at + 4]) + 256 * uchar(bytes[at + 5]), 25);
}

City tower() {
    City city = tests::cityOf({{{-10, -10, 0}, {10, 10, 60}}});
    city.frame = Frame({-73.98, 40.75});
    return city;
}

ShadowMovie movieOf(const City& baseline, int frames) {
    ShadowMovie movie{.baseline = std::make_shared<const City>(baseline),
                      .when = {{"2026-03-21"}, {}, 0, "America/New_York"},
                      .title = "Test"};
    for (int i = 0; i < frames; ++i) movie.when.times.push_back(std::to_string(10 + i) + ":00");
    movie.drawing.area = Box2{{-100, -60}, {100, 100}};
    movie.format.size = {320, 180};
    return movie;
}

TEST(ShadowMovie, HasOneFrameATime) {
    const tests::TemporaryFolder folder;
    const City before = tower();
    NoProgress progress;
    const auto made = writeShadowMovie(movieOf(before, 5), folder.path("day.mp4"), progress, {});
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_EQ(made->frames, 5U);
    EXPECT_EQ(bytesOf(folder.path("day.mp4")).mid(4, 4), "ftyp");
}

// The frame is wider than the area: the shadows are computed for what it shows.
TEST(ShadowMovie, ShowsShadowsInTheWholeFrame) {
    const tests::TemporaryFolder folder;
    const City before = tower();
    NoProgress progress;
    ShadowMovie movie = movieOf(before, 1);
    movie.drawing.area = Box2{{-20, -20}, {20, 20}};
    const auto made = writeShadowMovie(movie, folder.path("day.gif"), progress, {});
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_LT(made->area.low.x, -35);
    EXPECT_GT(made->area.high.x, 35);
    EXPECT_NEAR(made->area.low.y, -20, 1e-3);
    EXPECT_NEAR(made->area.high.y, 20, 1e-3);
}

TEST(ShadowMovie, SwipesFromTheBaselineToTheScenario) {
    const tests::TemporaryFolder folder;
    const City before = tower();
    City after = before;
    after.buildings.push_back(tests::buildingOf({{30, -10, 0}, {40, 10, 40}}));
    NoProgress progress;
    ShadowMovie movie = movieOf(before, 1);
    movie.scenario = std::make_shared<const City>(after);
    movie.swipe = true;
    const auto made = writeShadowMovie(movie, folder.path("swipe.gif"), progress, {});
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_GT(made->frames, 48U);
    movie.scenario.reset();
    EXPECT_FALSE(writeShadowMovie(movie, folder.path("swipe.gif"), progress, {}));
}

TEST(ShadowMovie, LeavesNoFileWhenItIsStopped) {
    const tests::TemporaryFolder folder;
    const City before = tower();
    NoProgress progress;
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(writeShadowMovie(movieOf(before, 3), folder.path("day.mp4"), progress, stop.get_token()));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path("day.mp4").parent_path()));
}

}  // namespace
}  // namespace noonmark
