#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include "app/gui/base/widgets/number_text.h"
#include "app/gui/view/time/moment_preview.h"
#include "app/gui/view/time/time_strip.h"
#include "core/engines/projected/projected_shadows.h"
#include "tests/gui/small_city.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using namespace std::chrono_literals;
using test::waitFor;

std::shared_ptr<const Study> smallStudy() {
    StudySettings settings;
    settings.region = {"around", {test::square({-120, -120}, 240)}};
    settings.receivers.cellM = 4;
    settings.period = {.days = 30, .from = 8h, .hours = 8, .stepMinutes = 5, .zone = "America/New_York"};
    settings.errorSample.receivers = 0;
    NoProgress progress;
    return std::make_shared<const Study>(runStudy(test::smallCity(), settings, progress, {}).value());
}

const ShownTime may{ShownSpan::day, {2026y, std::chrono::May, 4d}, 14h};

TEST(ShownTime, IsAPartOfTheStudysTime) {
    Period study = smallStudy()->settings.period;
    study.window = SolarHours{};
    EXPECT_EQ(periodOf(ShownTime{}, study), study);
    const Period day = periodOf(may, study);
    EXPECT_EQ(day.start, may.date);
    EXPECT_EQ(day.days, 1);
    EXPECT_EQ(day.window, study.window) << "a day has the hours of the study";
    const Period moment = periodOf({ShownSpan::moment, may.date, 14h}, study);
    EXPECT_EQ(moment.hours, 0);
    EXPECT_EQ(moment.from, 14h);
    EXPECT_FALSE(moment.window);
    EXPECT_EQ(describe({ShownSpan::moment, may.date, 14h + 5min}), "4 May 2026, 14:05");
}

TEST(TimeStrip, SlidersGoOverTheYearOfTheStudyByDaysAndMinutes) {
    TimeStrip strip;
    strip.setPeriod({.start = {2028y, std::chrono::February, 27d}, .hours = 4});
    QSignalSpy looks(&strip, &TimeStrip::lookChanged);
    strip.findChild<QComboBox*>(QStringLiteral("lookSpan"))->setCurrentIndex(int(ShownSpan::moment));
    auto* date = strip.findChild<QSlider*>(QStringLiteral("lookDate"));
    auto* time = strip.findChild<QSlider*>(QStringLiteral("lookTime"));
    EXPECT_EQ(date->maximum(), 365) << "2028 is a leap year";
    EXPECT_EQ(time->value(), 11 * 60) << "the middle of the hours";
    date->setValue(date->value() + 2);
    time->setValue(16 * 60 + 30);
    EXPECT_EQ(looks.count(), 3);
    EXPECT_EQ(strip.look(), (ShownTime{ShownSpan::moment, {2028y, std::chrono::February, 29d}, 16h + 30min}));
    strip.setPeriod({.start = {2028y, std::chrono::June, 1d}});
    EXPECT_EQ(strip.look().date, CivilDate(2028y, std::chrono::February, 29d)) << "another run of the year";
    strip.setPeriod({.start = {2026y, std::chrono::June, 1d}});
    EXPECT_EQ(strip.look().date, CivilDate(2026y, std::chrono::June, 1d));
}

TEST(TimeStrip, TakesATimeAsItIsTyped) {
    TimeStrip strip;
    strip.setPeriod({.start = {2026y, std::chrono::November, 28d}, .hours = 4});
    auto* field = strip.findChild<QLineEdit*>(QStringLiteral("lookTimeField"));
    const auto type = [&](const char* text) {
        field->selectAll();
        QTest::keyClicks(field, QLatin1String(text));
        QTest::keyClick(field, Qt::Key_Return);
        return strip.look().at.count();
    };
    EXPECT_EQ(type("12:00"), 720);
    EXPECT_EQ(type("9"), 540);
    EXPECT_EQ(type("1430"), 870);
    EXPECT_EQ(type("6.15"), 375);
    EXPECT_EQ(type("25:00"), 375) << "there is no such time";
    EXPECT_EQ(field->text(), QStringLiteral("06:15"));
}

TEST(TimeStrip, TakesADateAsItIsTyped) {
    TimeStrip strip;
    strip.setPeriod({.start = {2026y, std::chrono::November, 28d}, .hours = 4});
    auto* field = strip.findChild<QLineEdit*>(QStringLiteral("lookDateField"));
    const auto type = [&](const char* text) {
        field->selectAll();
        QTest::keyClicks(field, QLatin1String(text));
        QTest::keyClick(field, Qt::Key_Return);
        return strip.look().date;
    };
    EXPECT_EQ(type("21 Dec"), CivilDate(2026y, std::chrono::December, 21d));
    EXPECT_EQ(type("june 3"), CivilDate(2026y, std::chrono::June, 3d));
    EXPECT_EQ(type("4"), CivilDate(2026y, std::chrono::June, 4d));
    EXPECT_EQ(type("24.12."), CivilDate(2026y, std::chrono::December, 24d));
    EXPECT_EQ(type("2026-02-28"), CivilDate(2026y, std::chrono::February, 28d));
    EXPECT_EQ(type("30 Feb"), CivilDate(2026y, std::chrono::February, 28d)) << "there is no such day";
    EXPECT_EQ(field->text(), QStringLiteral("28 Feb"));
    EXPECT_EQ(parseDay(QStringLiteral("x"), QDate(2026, 1, 1)), QDate());
}

// Bins of half a degree misplace a shadow's edge by up to a quarter of a degree of azimuth.
TEST(MomentPreview, FollowsTheSliderAndEndsAtItsLastPlace) {
    const auto study = smallStudy();
    MomentPreview looking;
    looking.setStudy(study);
    EXPECT_FALSE(looking.answer()) << "the whole period needs no separate answer";
    ShownTime look{ShownSpan::moment, {2026y, std::chrono::May, 4d}, 9h};
    for (; look.at < 15h; look.at += 7min) {
        looking.look(look);
        QCoreApplication::processEvents();
    }
    look.at -= 7min;
    ASSERT_TRUE(waitFor([&] { return looking.answer() && looking.answer()->look == look; }));
    NoProgress progress;
    const auto sun = computeSunSteps(periodOf(look, study->settings.period), makeObserver(*study)).value();
    const ShadowField exact =
        ProjectedShadows().accumulate(study->city, study->receivers, sun, progress, {}).value();
    std::size_t shaded = 0, other = 0;
    for (const std::uint32_t cell : study->receivers.cells) {
        shaded += exact.grossMin[cell] > 0;
        other += exact.grossMin[cell] != looking.answer()->field.grossMin[cell];
    }
    EXPECT_GT(shaded, 100U);
    EXPECT_LT(other, study->receivers.cells.size() / 50);
    looking.look({});
    EXPECT_FALSE(looking.answer());
}

TEST(MomentPreview, NightIsReportedAndTheNextMomentAnswered) {
    MomentPreview looking;
    QStringList said;
    QObject::connect(
        &looking, &MomentPreview::failed, &looking,
        [&said](const ShownTime&, const Error& error) { said << QString::fromStdString(error.what); });
    looking.setStudy(smallStudy());
    looking.look({ShownSpan::moment, may.date, 2h});
    ASSERT_TRUE(waitFor([&] { return !said.isEmpty(); }));
    EXPECT_EQ(said.front(), "The sun is below the horizon all the time");
    looking.look(may);
    ASSERT_TRUE(waitFor([&] { return looking.answer() != nullptr; }));
    EXPECT_EQ(looking.answer()->look, may);
    looking.setStudy(nullptr);
    EXPECT_FALSE(looking.answer());
}

}  // namespace
}  // namespace noonmark
