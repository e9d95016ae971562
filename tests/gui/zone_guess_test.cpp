#include "app/window/zone_guess.h"

#include <gtest/gtest.h>

#include <QIODevice>

namespace noonmark {
namespace {

TEST(ZoneGuess, ReadsPlacesOfTheTable) {
    const auto newYork = placeFromIso6709(QStringLiteral("+404251-0740023"));
    ASSERT_TRUE(newYork);
    EXPECT_NEAR(newYork->latDeg, 40.7142, 1e-4);
    EXPECT_NEAR(newYork->lonDeg, -74.0064, 1e-4);
    const auto sydney = placeFromIso6709(QStringLiteral("-3352+15113"));
    ASSERT_TRUE(sydney);
    EXPECT_NEAR(sydney->latDeg, -33.8667, 1e-4);
    EXPECT_FALSE(placeFromIso6709(QStringLiteral("40N 74W")));
}

TEST(ZoneGuess, TakesTheNearestCity) {
    QString text = QStringLiteral(
        "# comment\nUS\t+404251-0740023\tAmerica/New_York\tEastern\nAU\t-3352+15113\tAustralia/Sydney\n"
        "FJ\t-1808+17825\tPacific/Fiji\n");
    const auto zoneAt = [&text](LonLat place) {
        QTextStream table(&text, QIODevice::ReadOnly);
        return nearestZone(table, place).value_or(QString());
    };
    EXPECT_EQ(zoneAt({-73.97, 40.77}), QStringLiteral("America/New_York"));
    EXPECT_EQ(zoneAt({150, -34}), QStringLiteral("Australia/Sydney"));
    EXPECT_EQ(zoneAt({-179.5, -17}), QStringLiteral("Pacific/Fiji")) << "across the date line";
}

TEST(ZoneGuess, AnEmptyTableGivesNothing) {
    QString nothing;
    QTextStream empty(&nothing, QIODevice::ReadOnly);
    EXPECT_FALSE(nearestZone(empty, {}));
}

}  // namespace
}  // namespace noonmark
