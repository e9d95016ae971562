#include "app/gui/session/study/open_city.h"

#include <gtest/gtest.h>

#include <QFile>

#include "core/sun/zone_country.h"

namespace noonmark {
namespace {

TEST(ZoneGuess, ReadsPlacesOfTheTable) {
    const auto newYork = parseIso6709(QStringLiteral("+404251-0740023"));
    ASSERT_TRUE(newYork);
    EXPECT_NEAR(newYork->latDeg, 40.7142, 1e-4);
    EXPECT_NEAR(newYork->lonDeg, -74.0064, 1e-4);
    const auto sydney = parseIso6709(QStringLiteral("-3352+15113"));
    ASSERT_TRUE(sydney);
    EXPECT_NEAR(sydney->latDeg, -33.8667, 1e-4);
    EXPECT_FALSE(parseIso6709(QStringLiteral("40N 74W")));
}

std::vector<ZoneCity> smallTable() {
    QString text = QStringLiteral(
        "# comment\nUS\t+404251-0740023\tAmerica/New_York\tEastern\nAU\t-3352+15113\tAustralia/Sydney\n"
        "FJ\t-1808+17825\tPacific/Fiji\n");
    QTextStream table(&text, QIODevice::ReadOnly);
    return zoneCities(table);
}

TEST(ZoneGuess, TakesTheNearestCity) {
    const auto zoneAt = [](LonLat place) { return guessZone(smallTable(), {}, place).zone; };
    EXPECT_EQ(zoneAt({-73.97, 40.77}), QStringLiteral("America/New_York"));
    EXPECT_EQ(zoneAt({150, -34}), QStringLiteral("Australia/Sydney"));
    EXPECT_EQ(zoneAt({-179.5, -17}), QStringLiteral("Pacific/Fiji")) << "across the date line";
}

TEST(ZoneGuess, EmptyListsGiveUtc) { EXPECT_EQ(guessZone({}, {}, {}), ZoneGuess{}); }

// A gazetteer may predate a change of a city's clock that the tz database knows.
TEST(ZoneGuess, ThePrincipalCityOfTheSameCountryCounts) {
    const std::vector<ZoneCity> principal{
        {{-106.483, 31.733}, QStringLiteral("MX"), QStringLiteral("America/Ciudad_Juarez")}};
    const std::vector<ZoneCity> cities{
        {{-106.461, 31.721}, QStringLiteral("MX"), QStringLiteral("America/Ojinaga")},
        {{-106.487, 31.759}, QStringLiteral("US"), QStringLiteral("America/Denver")}};
    EXPECT_EQ(guessZone(principal, cities, {-106.42, 31.69}).zone, QStringLiteral("America/Ciudad_Juarez"));
    EXPECT_EQ(guessZone(principal, cities, {-106.48, 31.77}).zone, QStringLiteral("America/Denver"));
}

TEST(ZoneGuess, SaysWhereAnotherClockIsNear) {
    const std::vector<ZoneCity> principal{
        {{-114.05, 35.19}, QStringLiteral("US"), QStringLiteral("America/Phoenix")}};
    const std::vector<ZoneCity> cities{
        {{-114.57, 35.13}, QStringLiteral("US"), QStringLiteral("America/Phoenix")},
        {{-114.60, 35.12}, QStringLiteral("US"), QStringLiteral("America/Los_Angeles")}};
    const ZoneGuess guess = guessZone(principal, cities, {-114.57, 35.13});
    EXPECT_EQ(guess.zone, QStringLiteral("America/Phoenix"));
    EXPECT_EQ(guess.others, QStringList{QStringLiteral("America/Los_Angeles")});
    EXPECT_TRUE(guessZone(principal, {}, {-114, 35}).others.isEmpty());
}

struct KnownZone {
    const char* city;
    LonLat place;
    const char* zone;
};

// City centres, from public gazetteers.
const KnownZone knownZones[] = {
    {"Monaco", {7.4200, 43.7325}, "Europe/Monaco"},
    {"Nice", {7.265, 43.700}, "Europe/Paris"},
    {"Lyon", {4.84, 45.76}, "Europe/Paris"},
    {"Strasbourg", {7.75, 48.58}, "Europe/Paris"},
    {"Basel", {7.5886, 47.5596}, "Europe/Zurich"},
    {"Vaduz", {9.521, 47.141}, "Europe/Vaduz"},
    {"Andorra la Vella", {1.521, 42.507}, "Europe/Andorra"},
    {"San Marino", {12.446, 43.936}, "Europe/San_Marino"},
    {"Vatican", {12.4533, 41.9022}, "Europe/Vatican"},
    {"Luxembourg", {6.13, 49.61}, "Europe/Luxembourg"},
    {"Gibraltar", {-5.353, 36.14}, "Europe/Gibraltar"},
    {"Ceuta", {-5.319, 35.889}, "Africa/Ceuta"},
    {"Gothenburg", {11.97, 57.70}, "Europe/Stockholm"},
    {"Rotterdam", {4.45, 51.91}, "Europe/Amsterdam"},
    {"Manhattan", {-73.98, 40.75}, "America/New_York"},
    {"Detroit", {-83.046, 42.331}, "America/Detroit"},
    {"Windsor", {-83.000, 42.283}, "America/Toronto"},
    {"El Paso", {-106.487, 31.760}, "America/Denver"},
    {"Ciudad Juarez", {-106.424, 31.690}, "America/Ciudad_Juarez"},
    {"San Diego", {-117.160, 32.715}, "America/Los_Angeles"},
    {"Tijuana", {-117.030, 32.530}, "America/Tijuana"},
    {"Phoenix", {-112.074, 33.448}, "America/Phoenix"},
    {"Indianapolis", {-86.158, 39.768}, "America/Indiana/Indianapolis"},
    {"South Bend", {-86.25, 41.68}, "America/Indiana/Indianapolis"},
    {"Gary", {-87.34, 41.60}, "America/Chicago"},
    {"Chicago", {-87.63, 41.88}, "America/Chicago"},
    {"Honolulu", {-157.86, 21.31}, "Pacific/Honolulu"},
    {"Hong Kong", {114.158, 22.285}, "Asia/Hong_Kong"},
    {"Shenzhen", {114.057, 22.543}, "Asia/Shanghai"},
    {"Macau", {113.540, 22.193}, "Asia/Macau"},
    {"Singapore", {103.850, 1.290}, "Asia/Singapore"},
    {"Johor Bahru", {103.7578, 1.4655}, "Asia/Kuala_Lumpur"},
    {"Urumqi", {87.617, 43.825}, "Asia/Urumqi"},
    {"Kolkata", {88.36, 22.57}, "Asia/Kolkata"},
    {"Mumbai", {72.83, 18.93}, "Asia/Kolkata"},
    {"Chennai", {80.27, 13.08}, "Asia/Kolkata"},
    {"Kathmandu", {85.32, 27.71}, "Asia/Kathmandu"},
    {"Adelaide", {138.60, -34.93}, "Australia/Adelaide"},
    {"Broken Hill", {141.46, -31.96}, "Australia/Broken_Hill"},
    {"Eucla", {128.883, -31.675}, "Australia/Eucla"},
    {"Lord Howe", {159.08, -31.55}, "Australia/Lord_Howe"},
    {"Chatham", {-176.55, -43.95}, "Pacific/Chatham"},
    {"Taveuni", {179.98, -16.85}, "Pacific/Fiji"},
};

TEST(ZoneGuess, OfRealCities) {
    if (!QFile::exists(QStringLiteral("/usr/share/zoneinfo/zone.tab")) || listTowns().empty())
        GTEST_SKIP() << "no tz database or no gazetteer";
    for (const KnownZone& known : knownZones)
        EXPECT_EQ(findNearestZone(known.place).zone.toStdString(), known.zone) << known.city;
    const ZoneGuess monaco = findNearestZone({7.42, 43.7325});
    EXPECT_EQ(monaco.zone, QStringLiteral("Europe/Monaco"));
    EXPECT_TRUE(monaco.others.isEmpty()) << "its neighbours' clocks show the same time";
}

}  // namespace
}  // namespace noonmark
