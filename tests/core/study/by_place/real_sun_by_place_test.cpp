#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/engines/ray/ray_reference.h"
#include "core/io/places/read_places.h"
#include "core/io/read_city.h"
#include "core/measures/places/place_receivers.h"
#include "core/study/by_place/sun_by_place.h"
#include "tests/shared/shared_data.h"

// Sun by place against a ray to every cell at every minute, on real places among real buildings.
namespace noonmark {
namespace {

using namespace std::chrono_literals;
using namespace tests;

struct RealPlaces {
    City city;
    std::vector<Place> places;
};

std::optional<RealPlaces> readFiftyPlaces() {
    const auto file = sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
    if (!file) return std::nullopt;
    NoProgress quiet;
    RealPlaces real{readCity({*file}, {}, quiet, {}).value().city, {}};
    const PlaceSettings withStreets{.streets = true, .wholeStreets = false, .sidewalkM = 4};
    const auto read = readPlaces(*file, withStreets, real.city.frame, quiet, {}).value();
    std::ranges::sample(read.places, std::back_inserter(real.places), 50, std::mt19937(42));
    return real;
}

SunByPlaceSettings ofDay(const CivilDate& day, const char* engine) {
    SunByPlaceSettings settings;
    settings.study.receivers.cellM = 2;
    settings.study.engine = engine;
    settings.study.errorSample.receivers = 0;
    settings.study.period = {
        .start = day, .stepMinutes = 1, .window = SolarHours{}, .zone = "America/New_York"};
    return settings;
}

/// Cells that rays are traced to.
struct TracedCells {
    PlaceReceivers on;
    ShadowField rays;
};

TracedCells trace(const City& city, std::span<const Place> places, double cellM, const SunSteps& sun) {
    const City* const cities[]{&city};
    NoProgress quiet;
    TracedCells traced{placeReceiversOnPlaces(cities, places, {.cellM = cellM}).value(), {}};
    traced.rays = RayReference().accumulate(city, traced.on.receivers, sun, quiet, {}).value();
    return traced;
}

// Of one place: the table's figures from rays, on the cells and with the shares of the answer.
SunOfPlace sumRays(const TracedCells& traced, std::size_t place, const SunOfPlace& as, double enoughHours) {
    const auto& [on, rays] = traced;
    SunOfPlace sun;
    double all = 0, hours = 0, enough = 0;
    for (std::size_t i = 0; i < as.ofCells.size(); ++i) {
        const std::uint32_t cell = on.receivers.cells[on.receiverOf(place, i)];
        const double at = (rays.sunlitMinutesPerDay - double(rays.grossMin[cell])) / 60;
        const auto share = double(as.ofCells[i].share);
        all += share;
        hours += share * at;
        if (at >= enoughHours) enough += share;
    }
    sun.meanHours = hours / all;
    sun.enoughShare = enough / all;
    return sun;
}

struct Differences {
    std::size_t places = 0, cells = 0, small = 0;  ///< small: with cells of their own
    double meanMin = 0, maxMin = 0, meanShare = 0, maxShare = 0;

    void add(const SunOfPlace& sun, const SunOfPlace& rays) {
        const double minutes = 60 * std::abs(sun.meanHours - rays.meanHours);
        ++places;
        cells += sun.ofCells.size();
        meanMin += minutes;
        maxMin = std::max(maxMin, minutes);
        const double share = std::abs(sun.enoughShare - rays.enoughShare);
        meanShare += share;
        maxShare = std::max(maxShare, share);
    }
    [[nodiscard]] std::string text() const {
        return fmt::format(
            "{} rows, {} cells; mean hours differ by {:.4f} min a day on average, {:.3f} at "
            "most; share with enough by {:.5f} on average, {:.4f} at most",
            places, cells, meanMin / double(places), maxMin, meanShare / double(places), maxShare);
    }
};

Differences compareWithRays(const RealPlaces& real, const CivilDate& day, const char* engine) {
    const SunByPlaceSettings settings = ofDay(day, engine);
    NoProgress quiet;
    const SunByPlace sun = runSunByPlace(real.city, real.places, settings, quiet, {}).value();
    const TracedCells together = trace(real.city, real.places, 2, sun.daylight);
    Differences all;
    for (std::size_t i = 0; i < real.places.size(); ++i) {
        const SunOfPlace& of = sun.sun[i];
        if (of.ofCells.empty()) continue;
        if (of.cellM == 2) {
            all.add(of, sumRays(together, i, of, settings.enoughHours));
            continue;
        }
        const TracedCells alone = trace(real.city, {&real.places[i], 1}, of.cellM, sun.daylight);
        all.add(of, sumRays(alone, 0, of, settings.enoughHours));
        ++all.small;
    }
    return all;
}

class RealSunByPlace : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Engines, RealSunByPlace, testing::Values("horizon", "projected"));

// Parks, streets and sidewalks: every cell and minute of the shortest and the longest day and of both
// equinoxes.
TEST_P(RealSunByPlace, FiftyPlacesOfMidtownHaveTheHoursThatRaysFind) {
    const auto real = readFiftyPlaces();
    if (!real) GTEST_SKIP() << "the shared Midtown extract is missing";
    const bool isExact = std::string(GetParam()) == "projected";
    for (const CivilDate day : {2026y / std::chrono::March / 21, 2026y / std::chrono::June / 21,
                                2026y / std::chrono::September / 21, 2026y / std::chrono::December / 21}) {
        const Differences differences = compareWithRays(*real, day, GetParam());
        RecordProperty("difference_" + formatText(day), differences.text());
        EXPECT_GT(differences.places, 40U);
        EXPECT_GT(differences.small, 3U) << "some have cells of 0.5 m";
        EXPECT_LT(differences.meanMin / double(differences.places), isExact ? 0.01 : 0.5)
            << differences.text();
        EXPECT_LT(differences.maxMin, isExact ? 0.5 : 5) << differences.text();
        EXPECT_LT(differences.maxShare, isExact ? 0.01 : 0.1) << differences.text();
    }
}

}  // namespace
}  // namespace noonmark
