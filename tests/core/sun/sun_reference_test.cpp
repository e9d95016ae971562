#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "core/sun/solar_position.h"
#include "core/sun/sun_events.h"
#include "tests/core/sun/sun_near.h"
#include "tests/shared/shared_data.h"

// Compares with published tables: NREL SPA, JPL Horizons, USNO.
namespace noonmark {
namespace {

using namespace tests;

constexpr double tolerance = 0.0003;

/// Rows of a comma separated file with a header line; no quotes, no commas within fields.
std::vector<std::map<std::string, std::string>> makeRows(const std::filesystem::path& path) {
    const auto split = [](const std::string& line) {
        std::vector<std::string> fields;
        std::istringstream stream(line);
        for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
        return fields;
    };
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    const auto header = split(line);
    std::vector<std::map<std::string, std::string>> rows;
    while (std::getline(file, line)) {
        const auto fields = split(line);
        auto& row = rows.emplace_back();
        for (std::size_t i = 0; i < fields.size() && i < header.size(); ++i) row[header[i]] = fields[i];
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
    const auto path = sharedData("reference/sun_position/nrel_spa_expected.csv");
    if (!path) GTEST_SKIP() << "no table of NREL SPA in the shared data";
    int compared = 0;
    for (auto& row : makeRows(*path)) {
        const bool spa = row["case"].starts_with("SPA");
        Observer observer = observerAt(number(row["lat"]), number(row["lon"]));
        observer.elevationM = number(row["elev_m"]);
        observer.pressureHPa = number(row["pressure_mbar"], observer.pressureHPa);
        observer.temperatureC = number(row["temp_C"], observer.temperatureC);
        const SolarPosition sun = computeSolarPosition(observer, instantOf(row["time_utc"]));
        // The row that is not SPA's comes from NOAA's short formulas, accurate to some 0.003 deg; its
        // refraction formula differs.
        const double allowed = spa ? tolerance : 0.003;
        EXPECT_LT(azimuthDifference(sun.azimuth, {number(row["azimuth_deg_N_cw"])}), allowed) << row["case"];
        EXPECT_NEAR(sun.altitude.value, number(row["elevation_true_deg"]), allowed) << row["case"];
        if (spa) {
            EXPECT_NEAR(sun.altitudeApparent.value, number(row["elevation_apparent_deg"]), allowed);
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
    const auto path = sharedData("reference/sun_position/nrel_spa_rise_set.csv");
    if (!path) GTEST_SKIP() << "no table of NREL SPA's sunrises in the shared data";
    int compared = 0;
    for (auto& row : makeRows(*path)) {
        const auto offset = std::chrono::hours{row["tz"] == "UTC" ? 0 : std::stoi(row["tz"].substr(3))};
        const Instant midnight = instantOf(row["date_local"]) - offset;
        const Observer observer = observerAt(number(row["lat"]), number(row["lon"]));
        const auto events = computeSunEvents(observer, midnight, SunriseRule::upperLimb);
        ASSERT_TRUE(events.sunrise && events.sunset);
        EXPECT_LE(secondsBetween(*events.sunrise, midnight + timeOfDay(row["sunrise"])), 1)
            << row["date_local"];
        EXPECT_LE(secondsBetween(events.transit, midnight + timeOfDay(row["transit"])), 1)
            << row["date_local"];
        const Instant sunset = sunsetOfUtcDay(observer, midnight, instantOf(row["date_local"]));
        EXPECT_LE(secondsOfDayBetween(sunset, midnight, timeOfDay(row["sunset"])), 1) << row["date_local"];
        ++compared;
    }
    EXPECT_GE(compared, 4);
}

class JplUsno : public ::testing::Test {
protected:
    void SetUp() override {
        const auto path = sharedData("reference/sun_position/suncalc_jpl_usno_fixtures.json");
        if (!path) GTEST_SKIP() << "no positions of JPL Horizons in the shared data";
        std::ifstream(*path) >> tables;
        for (const auto& location : tables["locations"]) {
            places[location["name"]] = observerAt(location["lat"], location["lng"]);
        }
    }

    nlohmann::json tables;
    std::map<std::string, Observer> places;
};

// Horizons gives refracted altitudes, for 1010 hPa and 10 deg C: the observer's defaults. Azimuth and
// altitude are compared as a direction on the sky; azimuth also separately, except with the sun so high that
// the same error on the sky is a larger error of azimuth.
TEST_F(JplUsno, EveryPositionAboveTwoDegrees) {
    int compared = 0;
    for (const auto& [name, bodies] : tables["positions"].items()) {
        for (const auto& [time, row] : bodies["sun"].items()) {
            const Degrees azimuth{row["azimuth"]};
            const Degrees altitude{row["altitude"]};
            if (altitude.value <= 2) continue;
            const SolarPosition sun = computeSolarPosition(places[name], instantOf(time));
            EXPECT_LT(separation(sun.azimuth, sun.altitudeApparent, azimuth, altitude), tolerance)
                << name << ' ' << time;
            EXPECT_NEAR(sun.altitudeApparent.value, altitude.value, tolerance) << name << ' ' << time;
            if (altitude.value < 45) {
                EXPECT_LT(azimuthDifference(sun.azimuth, azimuth), tolerance) << name << ' ' << time;
            }
            ++compared;
        }
    }
    EXPECT_EQ(compared, 352);
}

/// USNO's minute of a phenomenon of that day in UTC, if it occurs.
std::optional<std::chrono::seconds> usnoTime(const nlohmann::json& day, const std::string& phenomenon) {
    for (const auto& entry : day["sundata"]) {
        if (entry["phen"] == phenomenon && entry["time"].is_string()) return timeOfDay(entry["time"]);
    }
    return std::nullopt;
}

// USNO's times are rounded to the minute. Its days are those of UTC, ours those around local noon: an event
// on the other side of midnight is compared with that of the neighbouring day (up to 4 minutes apart at high
// latitudes).
TEST_F(JplUsno, RiseTransitAndSetWithinAMinute) {
    int compared = 0;
    for (const auto& [name, dates] : tables["times"].items()) {
        for (const auto& [date, day] : dates.items()) {
            const Instant midnight = instantOf(date);
            for (const auto& [phenomenon, pick] :
                 {std::pair{"Rise", 0}, std::pair{"Upper Transit", 1}, std::pair{"Set", 2}}) {
                const auto expected = usnoTime(day, phenomenon);
                if (!expected) continue;
                double nearest = 1e9;
                for (int shift : {-1, 0, 1}) {
                    const auto events = computeSunEvents(places[name], midnight + std::chrono::days{shift},
                                                         SunriseRule::upperLimb);
                    const auto event = pick == 0   ? events.sunrise
                                       : pick == 1 ? std::optional(events.transit)
                                                   : events.sunset;
                    if (event) nearest = std::min(nearest, secondsBetween(*event, midnight + *expected));
                }
                EXPECT_LE(nearest, 60) << name << ' ' << date << ' ' << phenomenon;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 400);
}

TEST_F(JplUsno, PolarDaysAndNights) {
    int compared = 0;
    for (const auto& [name, dates] : tables["times"].items()) {
        for (const auto& [date, day] : dates.items()) {
            for (const auto& entry : day["sundata"]) {
                const std::string phenomenon = entry["phen"];
                if (phenomenon != "Object continuously below the Horizon" &&
                    phenomenon != "Object continuously above the Horizon")
                    continue;
                const auto events = computeSunEvents(places[name], instantOf(date), SunriseRule::upperLimb);
                EXPECT_EQ(events.kind, phenomenon.find("above") != std::string::npos ? DayKind::polarDay
                                                                                     : DayKind::polarNight)
                    << name << ' ' << date;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 20);
}

}  // namespace
}  // namespace noonmark
