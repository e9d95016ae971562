#include "app/gui/view/panel/point_input.h"

#include <gtest/gtest.h>

#include "app/gui/base/looks/units.h"

namespace noonmark {
namespace {

using Taken = TypedLength::Taken;
constexpr auto withAzimuth = TypedLength::Form::lengthAndAzimuth;

void type(TypedLength& typed, const char* keys) {
    for (const char* key = keys; *key != '\0'; ++key) typed.take(QChar(*key).toUpper().unicode());
}

TEST(TypedLength, BeginsWithADigitAndTakesUnits) {
    TypedLength typed;
    EXPECT_EQ(typed.take(Qt::Key_M), Taken::no) << "a shortcut";
    EXPECT_FALSE(typed.claims(Qt::Key_4));
    type(typed, "131' 3\"");
    EXPECT_EQ(typed.text(), QStringLiteral("131' 3\""));
    EXPECT_TRUE(typed.claims(Qt::Key_M)) << "now it may be a unit";
    EXPECT_FALSE(typed.claims(Qt::Key_B));
    EXPECT_EQ(typed.take(Qt::Key_Return), Taken::entered);
    EXPECT_EQ(typed.finish(), QStringLiteral("131' 3\""));
    EXPECT_EQ(typed.take(Qt::Key_Return), Taken::no) << "nothing is typed";
}

TEST(TypedLength, BackspaceAndEscBelongToTheTextAsLongAsThereIsOne) {
    TypedLength typed;
    EXPECT_EQ(typed.take(Qt::Key_Backspace), Taken::no);
    type(typed, "40");
    EXPECT_EQ(typed.take(Qt::Key_Backspace), Taken::changed);
    EXPECT_EQ(typed.text(), QStringLiteral("4"));
    EXPECT_EQ(typed.take(Qt::Key_Escape), Taken::changed);
    EXPECT_TRUE(typed.empty());
    EXPECT_EQ(typed.take(Qt::Key_Escape), Taken::no);
}

TEST(TypedLength, ANumberAloneIsShownWithTheUnitInUse) {
    TypedLength typed(withAzimuth);
    type(typed, "40,5");
    EXPECT_EQ(typed.withUnit(), QStringLiteral("40.5 m"));
    type(typed, "<30");
    EXPECT_EQ(typed.withUnit(), QStringLiteral("40.5 m<30"));
    applyUnits(UnitSystem::imperial);
    EXPECT_EQ(typed.withUnit(), QStringLiteral("40.5 ft<30"));
    applyUnits(UnitSystem::metric);
    typed.clear();
    type(typed, "350 cm");
    EXPECT_EQ(typed.withUnit(), QStringLiteral("350 cm"));
}

TEST(TypedLength, TakesOneAngleWhereThereMayBeOne) {
    TypedLength height;
    type(height, "40<30");
    EXPECT_EQ(height.text(), QStringLiteral("4030"));
    TypedLength side(withAzimuth);
    type(side, "40<3;0");
    EXPECT_EQ(side.text(), QStringLiteral("40<30"));
}

TEST(TypedSide, IsALengthAndPerhapsAnAzimuth) {
    constexpr auto metric = UnitSystem::metric;
    EXPECT_EQ(parseTypedSide(QStringLiteral("40"), metric), (TypedSide{40, {}}));
    EXPECT_EQ(parseTypedSide(QStringLiteral("40 m<30.5"), metric), (TypedSide{40, 30.5}));
    EXPECT_EQ(parseTypedSide(QStringLiteral("40;270"), metric), (TypedSide{40, 270.0}));
    const auto feet = parseTypedSide(QStringLiteral("131' 3\""), metric);
    ASSERT_TRUE(feet);
    EXPECT_NEAR(feet->lengthM, 131.25 * 0.3048, 1e-12);
    EXPECT_NEAR(parseTypedSide(QStringLiteral("100"), UnitSystem::imperial)->lengthM, 30.48, 1e-12);
    for (const char* text : {"", "0", "40<", "<30", "40<3<0", "4 0 m"})
        EXPECT_FALSE(parseTypedSide(QString::fromLatin1(text), metric)) << text;
}

}  // namespace
}  // namespace noonmark
