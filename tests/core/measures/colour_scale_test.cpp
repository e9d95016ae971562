#include "core/measures/colour_scale.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace noonmark {
namespace {

constexpr double tenHoursMin = 600;
constexpr std::array<float, 5> fiveCells{0, 60, 120, 360, 600};

LegendChoice choiceOf(ShownAs show, const LegendClasses& classes = {}) {
    return {show, Ramp::noonmark, false, std::nullopt, classes};
}

ColourScale scaleOf(const LegendChoice& choice) {
    return makeColourScale(choice, {choice.show, tenHoursMin}, tenHoursMin, fiveCells);
}

TEST(ShownQuantity, SunIsTheSunlitTimeWithoutShadow) {
    const ShownQuantity shadow{ShownAs::shadow, tenHoursMin}, sun{ShownAs::sun, tenHoursMin},
        share{ShownAs::share, tenHoursMin};
    EXPECT_EQ(shadow.of(150), 150);
    EXPECT_EQ(sun.of(150), 7.5);
    EXPECT_EQ(share.of(150), 75);
    EXPECT_EQ(sun.of(600.001), 0) << "never below none";
    EXPECT_TRUE(std::isnan(sun.of(std::nan(""))));
    for (const ShownQuantity& one : {shadow, sun, share}) EXPECT_DOUBLE_EQ(one.minutesOf(one.of(150)), 150);
    EXPECT_EQ(share.of(0), 100);
}

TEST(ShownQuantity, MoreShadowIsLessSun) {
    EXPECT_EQ((ShownQuantity{ShownAs::shadow, tenHoursMin}.ofChange(12)), 12);
    EXPECT_EQ((ShownQuantity{ShownAs::sun, tenHoursMin}.ofChange(12)), -12);
    EXPECT_EQ((ShownQuantity{ShownAs::sun, tenHoursMin}.ofError(12)), 0.2) << "an error has no sign";
}

TEST(LegendChoice, IsTheSameAfterItsText) {
    for (const char* classes : {"continuous", "equal:4", "quantiles:3", "2,4.5,6", "2"}) {
        const auto read = parseLegendClasses(classes);
        ASSERT_TRUE(read) << classes;
        EXPECT_EQ(formatText(*read), classes);
        const LegendChoice choice{ShownAs::share, Ramp::magma, true, LegendRange{10, 90.5}, *read};
        EXPECT_EQ(parseLegendChoice(formatText(choice)), choice) << classes;
    }
    EXPECT_EQ(formatText(LegendChoice()), "{}");
    EXPECT_EQ(parseLegendChoice("no JSON"), LegendChoice());
}

TEST(LegendChoice, RefusesWhatIsNoRangeAndNoClasses) {
    for (const char* range : {"", "8", "8:0", "3:3", "a:b", "0:8x", "nan:1", "0:inf"})
        EXPECT_FALSE(parseLegendRange(range)) << range;
    for (const char* classes :
         {"", "equal", "equal:1", "equal:13", "equal:2.5", "4,2", "2,2", "2,", "some:3"})
        EXPECT_FALSE(parseLegendClasses(classes)) << classes;
}

TEST(LegendChoice, TakesARangeAsPeopleWriteIt) {
    for (const char* range : {"0:12", "0-12", "0..12", "0 to 12", " 0 - 12 ", "0\u201312"})
        EXPECT_EQ(parseLegendRange(range), (LegendRange{0, 12})) << range;
    EXPECT_EQ(parseLegendRange("-30--10"), (LegendRange{-30, -10}));
}

TEST(LegendChoice, KeepsItsClassesWhenSunIsShownInstead) {
    const LegendChoice shadow{ShownAs::shadow,
                              Ramp::noonmark,
                              false,
                              LegendRange{0, 480},
                              {LegendClasses::Kind::breaks, 5, {120, 360}}};
    const LegendChoice sun = showAs(shadow, ShownAs::sun, tenHoursMin);
    EXPECT_EQ(sun.range, (LegendRange{2, 10}));
    EXPECT_EQ(sun.classes.breaks, (std::vector<double>{4, 8}));
    EXPECT_EQ(showAs(sun, ShownAs::shadow, tenHoursMin), shadow);
}

TEST(ColourScale, PaintsNothingWhereThereIsNoShadow) {
    EXPECT_FALSE(scaleOf(choiceOf(ShownAs::shadow)).pick(0));
    EXPECT_TRUE(scaleOf(choiceOf(ShownAs::shadow)).pick(0.01));
    EXPECT_TRUE(scaleOf(choiceOf(ShownAs::sun)).pick(0)) << "full sun is what such a map shows";
    EXPECT_FALSE(scaleOf(choiceOf(ShownAs::sun)).pick(std::nan("")));
}

TEST(ColourScale, ACellHasTheSameColourAsShadowAndAsSun) {
    const ColourScale shadow = scaleOf(choiceOf(ShownAs::shadow)), sun = scaleOf(choiceOf(ShownAs::sun));
    EXPECT_EQ(shadow.high, 600);
    EXPECT_EQ(sun.high, 10) << "hours";
    EXPECT_EQ(shadow.pick(150), shadowRgb(0.25));
    EXPECT_EQ(sun.pick(150), shadowRgb(0.25));
    EXPECT_EQ(sun.pick(600), shadowRgb(1)) << "no sun is dark";
}

TEST(ColourScale, ClassesHaveTheirBreaks) {
    EXPECT_EQ(scaleOf(choiceOf(ShownAs::shadow, {LegendClasses::Kind::equal, 3, {}})).breaks,
              (std::vector<double>{200, 400}));
    EXPECT_EQ(scaleOf(choiceOf(ShownAs::shadow, {LegendClasses::Kind::quantiles, 2, {}})).breaks,
              std::vector<double>{360})
        << "of the four cells that are painted";
    const ColourScale threshold = scaleOf(choiceOf(ShownAs::sun, {LegendClasses::Kind::breaks, 5, {4}}));
    const auto classes = threshold.classes();
    ASSERT_EQ(classes.size(), 2U);
    EXPECT_EQ(classes[0].label, "below 4 h");
    EXPECT_EQ(classes[1].label, "4 h and more");
    EXPECT_EQ(threshold.pick(600 - 4 * 60), classes[1].colour) << "the threshold itself is reached";
    EXPECT_EQ(threshold.pick(600 - 3.99 * 60), classes[0].colour);
}

TEST(ColourScale, ReversedColoursAreTheOthersFromTheEnd) {
    LegendChoice choice = choiceOf(ShownAs::shadow);
    const auto before = scaleOf(choice).pick(150);
    choice.reversed = true;
    EXPECT_EQ(scaleOf(choice).pick(450), before);
}

ColourScale signedScale(ColourScale::Of of, ShownAs show, const LegendChoice& choice = {}) {
    return makeSignedScale(choice, of, {show, tenHoursMin}, {60, 10}, 0.001, std::vector<float>{-60, 0, 60});
}

TEST(ColourScale, AroundZeroNothingIsPaintedWhereNothingChanges) {
    for (const auto of : {ColourScale::Of::change, ColourScale::Of::wanted}) {
        const ColourScale scale = signedScale(of, ShownAs::shadow);
        for (const double none : {0.0, 0.001, -0.001, std::nan("")}) EXPECT_FALSE(scale.pick(none));
        for (const double some : {0.01, -0.01}) EXPECT_TRUE(scale.pick(some));
    }
}

TEST(ColourScale, AChangeHasTheSameColourAsShadowAndAsSunAndAScoreTheOpposite) {
    const ColourScale shadow = signedScale(ColourScale::Of::change, ShownAs::shadow),
                      sun = signedScale(ColourScale::Of::change, ShownAs::sun),
                      score = signedScale(ColourScale::Of::wanted, ShownAs::shadow);
    EXPECT_EQ(shadow.pick(60), rampRgb(Ramp::greenBrown, 1));
    EXPECT_EQ(sun.pick(60), shadow.pick(60));
    EXPECT_EQ(sun.shownOf(60), -60);
    EXPECT_EQ(score.pick(60), shadow.pick(-60));
}

TEST(ColourScale, ChangesHaveRampAndClassesOfTheirOwn) {
    LegendChoice choice;
    choice.changeRamp = Ramp::blueRed;
    choice.changeClasses = {LegendClasses::Kind::breaks, 5, {-30, 30}};
    const ColourScale scale = signedScale(ColourScale::Of::change, ShownAs::shadow, choice);
    ASSERT_EQ(scale.classes().size(), 3);
    EXPECT_EQ(scale.classes()[1].label, "-30 to 30 min");
    EXPECT_EQ(scale.pick(31), scale.classes()[2].colour);
    EXPECT_EQ(scale.classes()[1].colour, rampRgb(Ramp::blueRed, 0.5));
}

TEST(ColourScale, PlacesChangeFromVioletToOrangeAtTheThreshold) {
    const ColourScale scale = makeThresholdScale({}, 3, std::vector{8.5});
    ASSERT_EQ(scale.classes().size(), 6);
    const auto isViolet = [](Rgb rgb) { return rgb.blue > rgb.red; };
    EXPECT_TRUE(isViolet(scale.colourOf(2.99)));
    EXPECT_FALSE(isViolet(scale.colourOf(3)));
    LegendChoice choice;
    choice.ramp = Ramp::viridis;
    EXPECT_EQ(makeThresholdScale(choice, 3, std::vector{9.0}).ramp, Ramp::viridis);
}

TEST(LegendChoice, StatesOnTheCommandLineWhatWouldBeDrawnOtherwise) {
    LegendChoice choice{.show = ShownAs::sun, .ramp = Ramp::magma};
    choice.changeRamp = Ramp::blueRed;
    EXPECT_TRUE(listLegendOptions({}, false).empty());
    EXPECT_EQ(listLegendOptions(choice, false),
              (std::vector<CommandOption>{{"--show", {"sun"}}, {"--ramp", {"magma"}}}));
    EXPECT_EQ(listLegendOptions(choice, true),
              (std::vector<CommandOption>{{"--show", {"sun"}}, {"--change-ramp", {"blue-red"}}}));
}

TEST(ColourScale, PlacesHaveTheRangeAndTheClassesThatWereChosen) {
    const std::vector hours{1.0, 2.0, 3.0, 4.0, std::nan("")};
    LegendChoice choice{
        .show = ShownAs::sun, .range = LegendRange{0, 10}, .classes = {LegendClasses::Kind::equal, 5, {}}};
    EXPECT_EQ(makeThresholdScale(choice, 2, hours).breaks, (std::vector<double>{2, 4, 6, 8}));
    choice.classes = {LegendClasses::Kind::quantiles, 2, {}};
    EXPECT_EQ(makeThresholdScale(choice, 2, hours).breaks, std::vector<double>{3});
    choice.classes = {LegendClasses::Kind::breaks, 5, {1.5}};
    EXPECT_EQ(makeThresholdScale(choice, 2, hours).breaks, std::vector<double>{1.5});
    choice.show = ShownAs::shadow;
    EXPECT_EQ(makeThresholdScale(choice, 2, hours).breaks.size(), 5U)
        << "numbers of minutes are none of hours";
    EXPECT_EQ(makeThresholdScale(choice, 2, hours).high, 4);
}

TEST(ColourScale, ThereIsNoClassOfLessThanNoSun) {
    const auto classes = makeThresholdScale({}, 0, std::vector{6.0}).classes();
    ASSERT_EQ(classes.size(), 3U);
    EXPECT_EQ(classes.front().low, 0);
    EXPECT_EQ(classes.front().label, "0 to 2 h");
}

}  // namespace
}  // namespace noonmark
