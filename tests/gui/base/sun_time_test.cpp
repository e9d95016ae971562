#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QToolButton>
#include <glm/geometric.hpp>

#include "app/gui/base/widgets/marked_slider.h"
#include "app/gui/view/time/sun_at_moment.h"
#include "app/gui/view/time/time_strip.h"
#include "tests/gui/small_city.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using namespace std::chrono_literals;
using std::chrono::December;
using std::chrono::January;
using std::chrono::March;
using test::waitFor;

const Observer newYork{.place = {-73.98, 40.76}};
const Period inNewYork{.zone = "America/New_York"};
const ShownTime noon{ShownSpan::moment, {2026y, March, 21d}, 13h};

// Sunrise 6:58 and sunset 19:10 (timeanddate.com); at the equinox the noon sun is 90 - 40.8 + 0.2 degrees
// high.
TEST(SunAtMoment, IsThatOfTheAlmanac) {
    const SunAtMoment sun = computeSunAt(newYork, inNewYork, noon).value();
    EXPECT_NEAR(sun.altitudeDeg, 49.4, 0.4);
    EXPECT_NEAR(sun.azimuthDeg, 180, 3);
    EXPECT_NEAR(sun.sunriseMin.value(), 6 * 60 + 58, 2);
    EXPECT_NEAR(sun.sunsetMin.value(), 19 * 60 + 10, 2);
    EXPECT_NEAR(glm::length(sun.towards), 1, 1e-9);
    EXPECT_LT(sun.towards.y, 0) << "in the south";
    EXPECT_TRUE(describe(sun).contains(QStringLiteral(" S, "))) << describe(sun).toStdString();
    const SunAtMoment night = computeSunAt(newYork, inNewYork, {ShownSpan::moment, noon.date, 1h}).value();
    EXPECT_FALSE(night.isUp());
    EXPECT_EQ(describe(night), QStringLiteral("Sun below the horizon"));
}

TEST(SunAtMoment, PolarDaysHaveNeitherSunriseNorSunset) {
    const SunAtMoment sun = computeSunAt({.place = {20, 75}}, {.zone = "Europe/Oslo"},
                                         {ShownSpan::moment, {2026y, std::chrono::June, 21d}, 12h})
                                .value();
    EXPECT_TRUE(sun.isUp());
    EXPECT_FALSE(sun.sunriseMin);
    EXPECT_FALSE(sun.sunsetMin);
}

TEST(SunWalk, GoesThroughTheLightOfADayAndTheDatesOfAYear) {
    const SunAtMoment sun{.sunriseMin = 420, .sunsetMin = 1140};
    EXPECT_EQ(advance(noon, sun, SunLoop::day, 0.5, 1).at, 13h + 30min);
    ShownTime late = noon;
    late.at = 1139min;
    EXPECT_EQ(advance(late, sun, SunLoop::day, 0.5, 1).at, 420min) << "from sunset back to sunrise";
    ShownTime newYearsEve = noon;
    newYearsEve.date = {2026y, December, 31d};
    const ShownTime next = advance(newYearsEve, sun, SunLoop::year, 1.0 / 7, 1);
    EXPECT_EQ(next.date, CivilDate(2026y, January, 1d)) << "the same year again";
    EXPECT_EQ(next.at, noon.at);
    EXPECT_EQ(nudge(newYearsEve, 0, 5).date, newYearsEve.date) << "dates stay in the year";
    EXPECT_EQ(nudge(noon, -10, 1).at, 12h + 50min);
    EXPECT_EQ(nudge(noon, -5000, 0).at, 0min);
}

TEST(TimeStrip, ATouchOfASliderShowsThatMoment) {
    TimeStrip strip;
    strip.setPeriod(inNewYork);
    EXPECT_EQ(strip.look().span, ShownSpan::period);
    QSignalSpy looks(&strip, &TimeStrip::lookChanged);
    strip.findChild<QSlider*>(QStringLiteral("lookTime"))->setValue(600);
    EXPECT_EQ(looks.count(), 1);
    EXPECT_EQ(strip.look().span, ShownSpan::moment);
    EXPECT_EQ(strip.look().at, 10h);
    strip.move(10, 1);
    EXPECT_EQ(strip.look(), (ShownTime{ShownSpan::moment, {2026y, March, 22d}, 10h + 10min}));
    EXPECT_EQ(strip.findChild<QSlider*>(QStringLiteral("lookTime"))->value(), 610);
}

TEST(TimeStrip, MarksSolsticesEquinoxesSunriseAndSunset) {
    TimeStrip strip;
    strip.setPeriod(inNewYork);
    const auto* date = strip.findChild<MarkedSlider*>(QStringLiteral("lookDate"));
    ASSERT_EQ(date->marks().size(), 4U);
    EXPECT_EQ(date->marks()[0].value, 31 + 28 + 20) << "21 March";
    strip.setSun({.sunriseMin = 418, .sunsetMin = 1150});
    const auto* time = strip.findChild<MarkedSlider*>(QStringLiteral("lookTime"));
    ASSERT_EQ(time->marks().size(), 2U);
    EXPECT_EQ(time->marks()[0].label, QStringLiteral("06:58"));
}

// 546 pixels are its share of a window of 1366.
TEST(TimeStrip, NamesAllMonthsOfItsMarksInGermanToo) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    TimeStrip strip;
    QLocale::setDefault(before);
    strip.setLocale(QLocale(QLocale::German));
    strip.setPeriod(inNewYork);
    strip.setLook({ShownSpan::moment, noon.date, 13h});
    strip.setAttribute(Qt::WA_DontShowOnScreen);
    strip.resize(546, 60);
    strip.show();
    QCoreApplication::processEvents();
    EXPECT_EQ(strip.findChild<MarkedSlider*>(QStringLiteral("lookDate"))->labels().size(), 4U);
}

TEST(TimeStrip, ADayIsOfferedOnlyForAStudy) {
    TimeStrip strip;
    strip.setPeriod(inNewYork);
    strip.setDayOffered(true);
    strip.setLook({ShownSpan::day, noon.date, 13h});
    strip.setDayOffered(false);
    EXPECT_EQ(strip.look().span, ShownSpan::period);
}

TEST(TimeStrip, PlaysUntilItIsStopped) {
    TimeStrip strip;
    strip.setPeriod(inNewYork);
    strip.setSun({.sunriseMin = 400, .sunsetMin = 1100});
    QSignalSpy looks(&strip, &TimeStrip::lookChanged);
    auto* play = strip.findChild<QToolButton*>(QStringLiteral("playSun"));
    play->click();
    EXPECT_TRUE(strip.playing());
    ASSERT_TRUE(waitFor([&looks] { return looks.count() > 3; }));
    EXPECT_EQ(strip.look().span, ShownSpan::moment);
    play->click();
    EXPECT_FALSE(strip.playing());
}

TEST(SunShadow, TheNewestViewIsDrawnLast) {
    SunShadow shadow;
    shadow.setCity(std::make_shared<const City>(test::smallCity()));
    const LitSpace space{{{-200, -200}, {200, 200}}, 0, 100};
    glm::dvec3 sun;
    for (const double east : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        sun = glm::normalize(glm::dvec3(east, -1, 1));
        shadow.look(SunView{sun, space, 256});
    }
    ASSERT_TRUE(waitFor([&] { return shadow.map() && shadow.map()->towardsSun == sun; }));
    EXPECT_EQ(shadow.map()->depth.size(), 256U * 256U);
    shadow.look(std::nullopt);
    EXPECT_EQ(shadow.map(), nullptr);
}

// The sun stands 45 degrees high in the south: shade falls as far north as what casts it is high. The middle
// of the crown is 6 m high.
TEST(SunShadow, TreesShadeTheGroundByTheirLeaves) {
    City city = test::smallCity();
    const glm::dvec2 place(150, -150);
    auto trees = std::make_shared<Trees>();
    trees->leafDays = {.on = 100, .off = 300};
    trees->trees.push_back({.place = place, .heightM = 10, .crownBaseM = 2, .crownDiameterM = 8});
    city.trees = trees;
    SunShadow shadow;
    shadow.setCity(std::make_shared<const City>(city));
    const auto mapOf = [&](int treeDay) {
        const auto before = shadow.map();
        shadow.look(
            SunView{glm::normalize(glm::dvec3(0, -1, 1)), {{{100, -200}, {200, -100}}, 0, 20}, 512, treeDay});
        EXPECT_TRUE(waitFor([&] { return shadow.map() && shadow.map() != before; }));
        return shadow.map() ? *shadow.map() : SunDepthMap{};
    };
    const auto shades = [](SunDepthMap map, const std::vector<float>& depth, glm::dvec3 point) {
        if (depth.empty()) return false;
        map.depth = depth;
        return map.shades(point, 0.1);
    };
    const glm::dvec3 under(place.x, place.y + 6, 0), beside(place.x + 12, place.y + 6, 0);
    const SunDepthMap summer = mapOf(200), winter = mapOf(10), none = mapOf(0);
    EXPECT_FALSE(summer.shades(under, 0.1)) << "the map of buildings";
    EXPECT_TRUE(shades(summer, summer.crowns, under));
    EXPECT_FALSE(shades(summer, summer.crowns, beside));
    EXPECT_TRUE(summer.bareCrowns.empty());
    EXPECT_TRUE(shades(winter, winter.bareCrowns, under));
    EXPECT_TRUE(winter.crowns.empty());
    EXPECT_TRUE(none.crowns.empty() && none.bareCrowns.empty());
}

}  // namespace
}  // namespace noonmark
