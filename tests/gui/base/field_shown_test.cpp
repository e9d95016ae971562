#include <gtest/gtest.h>

#include <limits>

#include "app/gui/base/layers/field_picture.h"
#include "app/gui/base/layers/ground_answer.h"
#include "app/gui/base/layers/hover_text.h"
#include "app/gui/docks/results/results_dock.h"
#include "app/report/maps/answer_legends.h"
#include "app/report/maps/style.h"
#include "tests/gui/small_city.h"

namespace noonmark {
namespace {

/// Four cells of 10 m in a row: sun, shadow, building, outside.
struct FieldShown : ::testing::Test {
    static constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    ShadowField field;
    Receivers receivers;

    FieldShown() {
        field.grid = receivers.grid = {0, 0, 10, 4, 1};
        field.grossMin = {0, 60, nan, nan};
        field.continuousMin = {0, 30, nan, nan};
        field.sunlitMinutesPerDay = 360;
        receivers.kind = {CellKind::ground, CellKind::ground, CellKind::building, CellKind::outside};
    }
    static GroundPicture::Pixel pixelOf(double share) {
        const QColor colour = shadowColour(share);
        return {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue()), 255};
    }
};

TEST_F(FieldShown, PictureHasTheReportsColours) {
    const GroundPicture picture = fieldPicture(field, &receivers, ShadowMeasure::gross, plainScale(60));
    EXPECT_EQ(picture.pixels[0], pixelOf(0));
    EXPECT_EQ(picture.pixels[1], pixelOf(1));
    EXPECT_EQ(picture.pixels[2], pixelOf(1)) << "under a building: the colour of the ground beside it";
    EXPECT_EQ(picture.pixels[3].a, 0) << "outside the region the ground keeps its own colour";
    EXPECT_EQ(fieldPicture(field, &receivers, ShadowMeasure::continuous, plainScale(60)).pixels[1],
              pixelOf(0.5));
    receivers.kind[2] = CellKind::water;
    EXPECT_EQ(fieldPicture(field, &receivers, ShadowMeasure::gross, plainScale(60)).pixels[2].a, 0)
        << "and so does water";
}

TEST_F(FieldShown, RoofsHaveAPictureOfTheirOwn) {
    EXPECT_FALSE(roofPicture(field, receivers, ShadowMeasure::gross, plainScale(60)))
        << "no receiver is on a roof";
    field.grossMin[2] = 30;
    receivers.kind[2] = CellKind::roof;
    const auto roofs = roofPicture(field, receivers, ShadowMeasure::gross, plainScale(60));
    ASSERT_TRUE(roofs);
    EXPECT_EQ(roofs->pixels[0].a, 0);
    EXPECT_EQ(roofs->pixels[1], pixelOf(0.5)) << "the roof's edge ends within this cell";
    EXPECT_EQ(roofs->pixels[2], pixelOf(0.5));
    const GroundPicture ground = fieldPicture(field, &receivers, ShadowMeasure::gross, plainScale(60));
    EXPECT_EQ(ground.pixels[1], pixelOf(1));
    EXPECT_EQ(ground.pixels[2], pixelOf(1)) << "the ground beside, not the roof";
}

TEST(ScoreShown, WantedShadeHasTheColourOfLessShadow) {
    Score score;
    score.grid = {0, 0, 10, 3, 1};
    score.score = {1, -1, std::numeric_limits<float>::quiet_NaN()};
    const Legend legend = makeLegend(score);
    EXPECT_EQ(legend.scale.top, 1);
    EXPECT_TRUE(legend.colours->isWanted());
    const GroundPicture picture = scorePicture(score, coloursOf(legend));
    EXPECT_EQ(picture.pixels[0], pixelOf(impactColour(-1)));
    EXPECT_EQ(picture.pixels[1], pixelOf(impactColour(1)));
    EXPECT_EQ(picture.pixels[2].a, 0);
    EXPECT_EQ(formatScore(score, {5, 5}), QStringLiteral("score +1.000 m² a m²"));
    EXPECT_EQ(formatScore(score, {25, 5}), QStringLiteral("not measured"));
    EXPECT_EQ(formatScore(score, {95, 5}), QString());
}

TEST_F(FieldShown, HoverSaysMinutesAndPlace) {
    const auto textAt = [this](double x) {
        return hoverText({{x, 5, 0}, std::nullopt}, test::smallCity(), formatMinutes(field, {x, 5}))
            .toStdString();
    };
    EXPECT_NE(textAt(15).find("x 15.0 m, y 5.0 m"), std::string::npos) << textAt(15);
    EXPECT_NE(textAt(15).find("gross 60.0 min a day, continuous 30.0 min"), std::string::npos) << textAt(15);
    EXPECT_NE(textAt(25).find("not measured"), std::string::npos) << textAt(25);
    EXPECT_EQ(textAt(95).find("min"), std::string::npos) << textAt(95);
}

TEST_F(FieldShown, HoverNamesTheBuilding) {
    const std::string text = hoverText({{0, -40, 60}, 0U}, test::smallCity(), {}).toStdString();
    EXPECT_NE(text.find("South House, 60.0 m high"), std::string::npos) << text;
}

TEST(WarningsDock, GroupsWithIds) {
    WarningsDock dock;
    dock.show({{WarningKind::repaired, "outline crossed itself", "way 1"},
               {WarningKind::leftOut, "underground", "way 2"},
               {WarningKind::repaired, "outline crossed itself", "way 3"}});
    ASSERT_EQ(dock.topLevelItemCount(), 2);
    EXPECT_TRUE(dock.topLevelItem(0)->text(0).startsWith(QStringLiteral("2 repaired")));
    EXPECT_EQ(dock.topLevelItem(0)->child(1)->text(0), QStringLiteral("way 3"));
}

TEST(WarningsDock, SaysHowManyItDoesNotShow) {
    WarningsDock dock;
    dock.show(Warnings(5000, {WarningKind::assumed, "height", "way"}));
    const QTreeWidgetItem* group = dock.topLevelItem(0);
    EXPECT_TRUE(group->child(group->childCount() - 1)->text(0).contains(QStringLiteral("and 3000 more")));
}

}  // namespace
}  // namespace noonmark
