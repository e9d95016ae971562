#include <gtest/gtest.h>

#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>

#include "app/gui/frame/main_window.h"
#include "app/gui/tools/editing/edit_tools.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/time/sun_at_moment.h"
#include "app/gui/view/time/time_strip.h"
#include "tests/gui/small_city.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using namespace std::chrono_literals;
using test::waitFor;

const Observer newYork{.place = {-73.98, 40.76}};
const Period inNewYork{.start = 2025y / std::chrono::March / 21, .zone = "America/New_York"};

Instant at(std::chrono::year_month_day date, std::chrono::minutes utc) {
    return Instant(std::chrono::sys_days(date) + utc);
}

TEST(PresentTime, IsTheTimeAtTheCityInTheYearOfThePeriod) {
    const ShownTime look =
        findPresentTime(newYork, inNewYork, at(2026y / std::chrono::June / 21, 18h + 5min)).value().look;
    EXPECT_EQ(look, (ShownTime{ShownSpan::moment, 2025y / std::chrono::June / 21, 14h + 5min}));
}

TEST(PresentTime, IsNoonOfTheSameDayWhileTheSunIsDown) {
    const ShownTime look =
        findPresentTime(newYork, inNewYork, at(2026y / std::chrono::June / 22, 3h)).value().look;
    EXPECT_EQ(look, (ShownTime{ShownSpan::moment, 2025y / std::chrono::June / 21, 12h}))
        << "eleven in the evening before";
}

// In midwinter the sun of New York is 1 degree high at half past seven, 26 at noon.
TEST(PresentTime, IsNoonWhileTheSunIsLow) {
    const auto present =
        findPresentTime(newYork, inNewYork, at(2026y / std::chrono::December / 21, 12h + 30min)).value();
    EXPECT_EQ(present.look.at, std::chrono::minutes(12h));
    EXPECT_TRUE(present.isNoon);
    // At 66 degrees north and 5 east the sun of 1 February is highest, 7 degrees, at ten to one: noon by
    // the clock has no higher sun, so that the moment stays.
    const Observer north{.place = {5, 66}};
    const Period there{.start = 2025y / std::chrono::March / 21, .zone = "Europe/Oslo"};
    EXPECT_FALSE(findPresentTime(north, there, at(2026y / std::chrono::February / 1, 11h + 50min))->isNoon);
}

TEST(PresentTime, TheDayThatAYearLacksIsTheLastOfItsMonth) {
    const ShownTime look =
        findPresentTime(newYork, inNewYork, at(2028y / std::chrono::February / 29, 17h)).value().look;
    EXPECT_EQ(look.date, 2025y / std::chrono::February / 28);
}

/// The window with a sample that is opened at 16:00 UTC, or at night there.
struct PresentWindow : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    MainWindow window{settings};

    void openAt(std::chrono::minutes utc) {
        window.time().setClock([utc] { return at(2026y / std::chrono::June / 21, utc); });
        window.resize(900, 640);
        window.show();
        window.open({QStringLiteral("sample:central-park-south")});
        ASSERT_TRUE(waitFor([this] { return window.workbench().city() != nullptr; }));
    }
    [[nodiscard]] const ShownTime& look() { return window.panel().time().look(); }
};

TEST_F(PresentWindow, ACityOpensWithTheSunOfNowAndNoResult) {
    openAt(16h);
    EXPECT_EQ(look().span, ShownSpan::moment);
    EXPECT_EQ(look().at, 12h) << "16:00 UTC in June";
    EXPECT_FALSE(window.panel().legend().legend());
    EXPECT_FALSE(window.exploration().working());
    EXPECT_TRUE(window.time().moment().startsWith(QStringLiteral("21 June 2026, 12:00. Sun ")))
        << window.time().moment().toStdString();
}

TEST_F(PresentWindow, AtNightItIsNoonAndSaysSo) {
    openAt(5h);
    EXPECT_EQ(look().span, ShownSpan::moment);
    EXPECT_EQ(look().at, 12h);
    EXPECT_TRUE(window.time().moment().startsWith(QStringLiteral("The sun is down or low there now")))
        << window.time().moment().toStdString();
}

TEST_F(PresentWindow, AnAnswerIsOfItsPeriodAndNotOfThatMoment) {
    openAt(16h);
    window.workbench().run();
    ASSERT_TRUE(waitFor([this] { return window.workbench().study() != nullptr; }, 60000));
    EXPECT_EQ(look().span, ShownSpan::period);
    EXPECT_TRUE(window.panel().legend().legend());
}

TEST_F(PresentWindow, TheStripFollowsTheDayOfTheStudyAndTheMovieTheStrip) {
    openAt(16h);
    StudySettings settings = window.workbench().document().settings();
    settings.period.start = settings.period.start.year() / std::chrono::December / 21;
    settings.period.days = 1;
    window.workbench().document().change(settings, QStringLiteral("period"));
    EXPECT_EQ(look().date.month(), std::chrono::December);
    EXPECT_EQ(look().at, 12h) << "the time stays";
    window.panel().time().choose({ShownSpan::moment, settings.period.start, 9h});
    settings.receivers.cellM = 5;
    window.workbench().document().change(settings, QStringLiteral("cell size"));
    EXPECT_EQ(look().at, 9h) << "other settings move nothing";
}

// What a tower changes is of the study's period: no other date stands beside it.
TEST_F(PresentWindow, OneDateIsShownWhileATowerIsDesigned) {
    openAt(16h);
    const ShownTime before = look();
    const Period& period = window.workbench().document().settings().period;
    ASSERT_NE(before.date, period.start);
    TowerEditing& tower = window.tools().tower();
    tower.begin({"Lot", test::square({0, 0}, 30)}, {}, {.storeys = 10});
    ASSERT_TRUE(window.tools().context().preview.shown());
    EXPECT_EQ(look().span, ShownSpan::period);
    EXPECT_EQ(look().date, period.start);
    EXPECT_FALSE(window.exploration().working()) << "the change is on the ground";
    tower.cancel();
    EXPECT_EQ(look(), before);
    EXPECT_FALSE(window.panel().legend().legend()) << "the moment, as before";
}

TEST_F(PresentWindow, AMomentThatTheUserChoseStays) {
    openAt(16h);
    window.panel().time().choose({ShownSpan::moment, look().date, 9h});
    window.mode().setMode(ViewMode::analysis);
    EXPECT_EQ(look().span, ShownSpan::moment);
    EXPECT_EQ(look().at, 9h);
    window.workbench().run();
    ASSERT_TRUE(waitFor([this] { return window.workbench().study() != nullptr; }, 60000));
    EXPECT_EQ(look().span, ShownSpan::period) << "who runs a question sees its answer";
    EXPECT_TRUE(window.panel().legend().legend());
}

}  // namespace
}  // namespace noonmark
