#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/sun/solar_position.h"
#include "core/sun/sun_paths.h"
#include "tests/core/sun/sun_near.h"
#include "tests/shared/shared_data.h"

// Compares with published tables: NREL SPA, JPL Horizons, USNO.
namespace noonmark {
namespace {

using namespace tests;

constexpr double tolerance = 0.0003;

using Row = std::map<std::string, std::string>;

/// The rows of a table in tests/core/sun/tables: comma separated with a header line; no quotes, no commas
/// within fields.
std::vector<Row> readTable(const std::string& name) {
    const auto split = [](const std::string& line) {
        std::vector<std::string> fields;
        std::istringstream stream(line);
        for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
        return fields;
    };
    std::ifstream file(testFile("core/sun/tables/" + name));
    std::string line;
    std::getline(file, line);
    const auto header = split(line);
    std::vector<Row> rows;
    while (std::getline(file, line)) {
        const auto fields = split(line);
        auto& row = rows.emplace_back();
        for (std::size_t i = 0; i < header.size(); ++i) row[header[i]] = i < fields.size() ? fields[i] : "";
    }
    return rows;
}

/// "2026-01-03T06:00:00Z"; the time is optional.
Instant instantOf(const std::string& text) {
    int year = 0;
    unsigned month = 0;
    unsigned day = 0;
    int hour = 0;
    int minute = 0;
    int second = 0;
    std::sscanf(text.c_str(), "%d-%u-%uT%d:%d:%d", &year, &month, &day, &hour, &minute, &second);
    return utc(year, month, day, hour, minute, second);
}

std::chrono::seconds timeOfDay(const std::string& text) {
    int hour = 0;
    int minute = 0;
    int second = 0;
    std::sscanf(text.c_str(), "%d:%d:%d", &hour, &minute, &second);
    return std::chrono::hours{hour} + std::chrono::minutes{minute} + std::chrono::seconds{second};
}

double number(const std::string& text, double missing = 0) {
    return text.empty() ? missing : std::stod(text);
}

TEST(SunReference, NrelSpaPositions) {
    int compared = 0;
    for (auto& row : readTable("spa_positions.csv")) {
        const bool spa = row["case"].starts_with("SPA");
        Observer observer = observerAt(number(row["lat"]), number(row["lon"]));
        observer.elevationM = number(row["elevation_m"]);
        observer.pressureHPa = number(row["pressure_hpa"], observer.pressureHPa);
        observer.temperatureC = number(row["temperature_c"], observer.temperatureC);
        const SolarPosition sun = computeSolarPosition(observer, instantOf(row["time_utc"]));
        // The row that is not SPA's comes from NOAA's short formulas, accurate to some 0.003 deg; its
        // refraction formula differs.
        const double allowed = spa ? tolerance : 0.003;
        EXPECT_LT(azimuthDifference(sun.azimuth, {number(row["azimuth_deg"])}), allowed) << row["case"];
        EXPECT_NEAR(sun.altitude.value, number(row["altitude_deg"]), allowed) << row["case"];
        if (spa) {
            EXPECT_NEAR(sun.altitudeApparent.value, number(row["apparent_altitude_deg"]), allowed);
        }
        compared += spa;
    }
    EXPECT_GE(compared, 2);
}

/// SPA's calculator gives the sunset of the day in UTC, as local time: in Colorado's summer that is the
/// previous evening.
Instant sunsetOfUtcDay(const Observer& observer, Instant localMidnight, Instant utcMidnight) {
    const Instant sunset = computeSunEvents(observer, localMidnight, SunriseRule::upperLimb).sunset.value();
    if (sunset < utcMidnight + std::chrono::days{1}) return sunset;
    return computeSunEvents(observer, localMidnight - std::chrono::days{1}, SunriseRule::upperLimb)
        .sunset.value();
}

/// Difference between an event and a time of day, on any day.
double secondsOfDayBetween(Instant event, Instant midnight, std::chrono::seconds time) {
    return std::abs(std::remainder(std::chrono::duration<double>(event - midnight - time).count(), 86400.0));
}

TEST(SunReference, NrelSpaRiseTransitSet) {
    int compared = 0;
    for (auto& row : readTable("spa_rise_set.csv")) {
        const auto offset = std::chrono::hours{row["zone"] == "UTC" ? 0 : std::stoi(row["zone"].substr(3))};
        const Instant midnight = instantOf(row["date"]) - offset;
        const Observer observer = observerAt(number(row["lat"]), number(row["lon"]));
        const auto events = computeSunEvents(observer, midnight, SunriseRule::upperLimb);
        ASSERT_TRUE(events.sunrise && events.sunset);
        EXPECT_LE(secondsBetween(*events.sunrise, midnight + timeOfDay(row["sunrise"])), 1) << row["date"];
        EXPECT_LE(secondsBetween(events.transit, midnight + timeOfDay(row["transit"])), 1) << row["date"];
        const Instant sunset = sunsetOfUtcDay(observer, midnight, instantOf(row["date"]));
        EXPECT_LE(secondsOfDayBetween(sunset, midnight, timeOfDay(row["sunset"])), 1) << row["date"];
        ++compared;
    }
    EXPECT_GE(compared, 4);
}

std::map<std::string, Observer> readPlaces() {
    std::map<std::string, Observer> places;
    for (auto& row : readTable("places.csv"))
        places[row["place"]] = observerAt(number(row["lat"]), number(row["lon"]));
    return places;
}

// Horizons gives refracted altitudes, for 1010 hPa and 10 deg C: the observer's defaults. Azimuth and
// altitude are compared as a direction on the sky; azimuth also separately, except with the sun so high that
// the same error on the sky is a larger error of azimuth.
TEST(SunReference, EveryPositionOfJplAboveTwoDegrees) {
    auto places = readPlaces();
    int compared = 0;
    for (auto& row : readTable("jpl_positions.csv")) {
        const std::string where = row["place"] + ' ' + row["time_utc"];
        const Degrees azimuth{number(row["azimuth_deg"])};
        const Degrees altitude{number(row["apparent_altitude_deg"])};
        const SolarPosition sun = computeSolarPosition(places.at(row["place"]), instantOf(row["time_utc"]));
        EXPECT_LT(separation(sun.azimuth, sun.altitudeApparent, azimuth, altitude), tolerance) << where;
        EXPECT_NEAR(sun.altitudeApparent.value, altitude.value, tolerance) << where;
        if (altitude.value < 45) {
            EXPECT_LT(azimuthDifference(sun.azimuth, azimuth), tolerance) << where;
        }
        ++compared;
    }
    EXPECT_EQ(compared, 352);
}

// USNO's times are rounded to the minute. Its days are those of UTC, ours those around local noon: an event
// on the other side of midnight is compared with that of the neighbouring day (up to 4 minutes apart at high
// latitudes).
TEST(SunReference, RiseTransitAndSetOfUsnoWithinAMinute) {
    auto places = readPlaces();
    int compared = 0;
    for (auto& row : readTable("usno_days.csv")) {
        const Instant midnight = instantOf(row["date_utc"]);
        for (const char* phenomenon : {"rise", "transit", "set"}) {
            if (row[phenomenon].empty()) continue;
            const Instant expected = midnight + timeOfDay(row[phenomenon]);
            double nearest = 1e9;
            for (int shift : {-1, 0, 1}) {
                const auto events = computeSunEvents(
                    places.at(row["place"]), midnight + std::chrono::days{shift}, SunriseRule::upperLimb);
                const auto event = phenomenon == std::string("rise")      ? events.sunrise
                                   : phenomenon == std::string("transit") ? std::optional(events.transit)
                                                                          : events.sunset;
                if (event) nearest = std::min(nearest, secondsBetween(*event, expected));
            }
            EXPECT_LE(nearest, 60) << row["place"] << ' ' << row["date_utc"] << ' ' << phenomenon;
            ++compared;
        }
    }
    EXPECT_GT(compared, 400);
}

TEST(SunReference, PolarDaysAndNightsOfUsno) {
    auto places = readPlaces();
    int compared = 0;
    for (auto& row : readTable("usno_days.csv")) {
        if (row["polar"].empty()) continue;
        const auto events =
            computeSunEvents(places.at(row["place"]), instantOf(row["date_utc"]), SunriseRule::upperLimb);
        EXPECT_EQ(events.kind, row["polar"] == "day" ? DayKind::polarDay : DayKind::polarNight)
            << row["place"] << ' ' << row["date_utc"];
        ++compared;
    }
    EXPECT_GT(compared, 20);
}

}  // namespace
}  // namespace noonmark
