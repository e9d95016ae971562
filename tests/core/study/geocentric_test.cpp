#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>

#include "core/base/progress.h"
#include "core/geo/frame.h"
#include "core/study/study.h"
#include "tests/core/study/geocentric_reference_erfa.h"

/// Compares districts far from the middle of their city with shadow computed on the ellipsoid.
namespace noonmark::tests {
namespace {

using namespace std::chrono;

constexpr double sideM = 240, cellM = 10, stepMinutes = 2;

struct TerrainDistrict {
    const char* name;
    Geodetic origin;  ///< origin of the city: the middle between its districts
    double eastM;     ///< position of the district
    double northM;
    sys_days date;
    int fromHour;  ///< UTC
    int hours;
    bool terrain = false;
};

void PrintTo(const TerrainDistrict& place, std::ostream* out) { *out << place.name; }

Geodetic districtOf(const TerrainDistrict& place) {
    return displaced(place.origin, place.eastM, place.northM);
}

// Blocks 12 to 60 m high on a lattice.
std::vector<GeoBox> blocksAround(Geodetic middle) {
    std::vector<GeoBox> blocks;
    for (int row = -1; row <= 1; ++row)
        for (int column = -1; column <= 1; ++column) {
            const double heightM = 12 + 6 * ((row + 1) * 3 + column + 1);
            blocks.push_back(
                geoBox(displaced(middle, 75 * column, 70 * row), 33 + 4 * row, 27 - 5 * column, heightM));
        }
    return blocks;
}

float dropAt(const TerrainDistrict& place, glm::dvec2 local) {
    return place.terrain ? -float(earthDropM(local)) : 0;
}

// Makes roofs level in the frame of the city, as those of footprints are: 45 km away on terrain they are
// inclined by 0.35 deg to the local level, 0.1 m at the edge of a block. Near noon, when the end of a shadow
// stands still, this changes single cells at that end by half an hour.
std::vector<GeoBox> levelInFrame(const TerrainDistrict& place, std::vector<GeoBox> blocks) {
    const Frame frame({place.origin.lonDeg, place.origin.latDeg});
    for (GeoBox& block : blocks) {
        double drops[4], middle = 0;
        for (int i = 0; i < 4; ++i) {
            drops[i] =
                dropAt(place, frame.localFromLonLat({block.corners[i].lonDeg, block.corners[i].latDeg}));
            middle += drops[i] / 4;
        }
        for (int i = 0; i < 4; ++i) block.heightsM[i] += middle - drops[i];
    }
    return blocks;
}

std::shared_ptr<const Building> blockBuildingOf(const TerrainDistrict& place, const Frame& frame,
                                                const GeoBox& box) {
    Part part;
    glm::dvec2 middle(0);
    for (const Geodetic& corner : box.corners) {
        const glm::dvec2 local = frame.localFromLonLat({corner.lonDeg, corner.latDeg});
        part.footprint.outer.push_back(glm::vec2(local));
        middle += local / 4.0;
    }
    constexpr float intoTheGround = 1;  // the sea slopes in the frame
    part.topM = dropAt(place, middle) + float(box.heightsM[0]);
    part.bottomM = dropAt(place, middle) - (place.terrain ? intoTheGround : 0);
    Building building;
    building.parts.push_back(std::move(part));
    return std::make_shared<const Building>(std::move(building));
}

// The sea around the origin, including both districts, in squares so small that none deviates by a
// millimetre.
std::shared_ptr<const Terrain> seaOf(const TerrainDistrict& place) {
    constexpr int cells = 880;
    constexpr double cellM = 125;
    Terrain sea{{-55e3, -55e3, cellM, cells, cells}, {}};
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column)
            sea.elevationM.push_back(dropAt(place, sea.grid.centre(column, row)));
    return std::make_shared<const Terrain>(std::move(sea));
}

City cityOf(const TerrainDistrict& place, const std::vector<GeoBox>& blocks) {
    City city{.frame = Frame({place.origin.lonDeg, place.origin.latDeg})};
    for (const GeoBox& block : blocks) city.buildings.push_back(blockBuildingOf(place, city.frame, block));
    if (place.terrain) city.terrain = seaOf(place);
    return city;
}

Study studyOf(const TerrainDistrict& place, const City& city, const std::string& engine) {
    const Geodetic middle = districtOf(place);
    const glm::vec2 centre(city.frame.localFromLonLat({middle.lonDeg, middle.latDeg}));
    StudySettings settings;
    settings.region = makeRegionFromLocalBox({centre - float(sideM / 2), centre + float(sideM / 2)});
    settings.receivers.cellM = cellM;
    settings.period.start = place.date;
    settings.period.from = hours(place.fromHour);
    settings.period.hours = place.hours;
    settings.period.stepMinutes = stepMinutes;
    settings.engine = engine;
    settings.errorSample.receivers = 0;
    NoProgress progress;
    auto study = runStudy(city, settings, progress, {});
    EXPECT_TRUE(study) << study.error().text();
    return std::move(*study);
}

std::vector<glm::dvec3> sunsOf(const TerrainDistrict& place) {
    std::vector<glm::dvec3> suns;
    const double first = double(duration_cast<seconds>(place.date.time_since_epoch()).count());
    for (int step = 0; step < int(place.hours * 60 / stepMinutes); ++step)
        suns.push_back(sunPlace(first + place.fromHour * 3600 + step * stepMinutes * 60));
    return suns;
}

struct Differences {
    int cells = 0;
    int grossOff = 0, longestOff = 0;  ///< cells off by more than a step
    double grossMean = 0, longestMean = 0, grossMost = 0, longestMost = 0, shaded = 0;
};

Differences differencesOf(const Study& study, const std::vector<GeoMinutes>& truth) {
    Differences found;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const std::uint32_t cell = study.receivers.cells[i];
        const double gross = std::abs(double(study.field.grossMin[cell]) - truth[i].gross);
        const double longest = std::abs(double(study.field.continuousMin[cell]) - truth[i].longest);
        found.grossMean += gross, found.longestMean += longest;
        found.grossOff += gross > stepMinutes + 1e-3, found.longestOff += longest > stepMinutes + 1e-3;
        found.grossMost = std::max(found.grossMost, gross);
        found.longestMost = std::max(found.longestMost, longest);
        found.shaded += truth[i].gross;
        ++found.cells;
    }
    for (double* sum : {&found.grossMean, &found.longestMean, &found.shaded}) *sum /= found.cells;
    return found;
}

std::string formatText(const Differences& d) {
    return fmt::format(
        "of {} cells, {:.1f} min in shadow: gross off by {:.3f} min in the mean, {:.1f} at most, {} by more "
        "than "
        "a step; longest run by {:.3f}, {:.1f}, {}",
        d.cells, d.shaded, d.grossMean, d.grossMost, d.grossOff, d.longestMean, d.longestMost, d.longestOff);
}

std::vector<GeoMinutes> computeTruth(const TerrainDistrict& place, const Receivers& receivers,
                                     const std::vector<GeoBox>& blocks) {
    const std::vector<glm::dvec3> suns = sunsOf(place);
    std::vector<GeoMinutes> truth;
    for (const std::uint32_t cell : receivers.cells) {
        const auto columns = std::uint32_t(receivers.grid.columns);
        const glm::dvec2 local = receivers.grid.centre(int(cell % columns), int(cell / columns));
        truth.push_back(minutesAt(underOrthographic(place.origin, local), blocks, suns, stepMinutes));
    }
    return truth;
}

class Geocentric : public testing::TestWithParam<TerrainDistrict> {};

// Tolerance: a step, since the moment that an edge passes falls on either side of one; in a few cells the sun
// grazes a corner.
TEST_P(Geocentric, ShadowOfADistrictFarFromTheMiddleOfItsCity) {
    const TerrainDistrict& place = GetParam();
    const std::vector<GeoBox> blocks = blocksAround(districtOf(place));
    const City city = cityOf(place, blocks);
    std::vector<GeoMinutes> truth;
    for (const char* engine : {"ray", "horizon", "projected"}) {
        if (place.terrain && engine == std::string("projected")) continue;  // level ground only
        const Study study = studyOf(place, city, engine);
        if (truth.empty()) truth = computeTruth(place, study.receivers, levelInFrame(place, blocks));
        const Differences found = differencesOf(study, truth);
        std::cout << place.name << ", " << engine << ": " << formatText(found) << '\n';
        EXPECT_GT(found.shaded, 30);
        EXPECT_LE(found.grossOff, place.terrain ? found.cells / 200 : 0) << engine;
        EXPECT_LE(found.longestOff, found.cells / 100) << engine;
        EXPECT_LE(found.grossMean, stepMinutes / 10) << engine;
        EXPECT_LE(found.longestMean, stepMinutes / 5) << engine;
    }
}

constexpr Geodetic north62{10, 62, 0}, sydney{151, -33.9, 0}, fiji{179.99, -17.5, 0};
constexpr sys_days march = 2026y / 3 / 21, june = 2026y / 6 / 20, fijiMarch = 2026y / 3 / 20;

INSTANTIATE_TEST_SUITE_P(
    Places, Geocentric,
    testing::Values(TerrainDistrict{"west_copy_62_north", north62, -27.5e3, 0, march, 6, 10},
                    TerrainDistrict{"east_copy_62_north", north62, 27.5e3, 0, march, 6, 10},
                    TerrainDistrict{"on_the_sea_45_km_off", north62, 45e3, 0, march, 6, 10, true},
                    TerrainDistrict{"south_west_of_sydney", sydney, -20e3, -20e3, june, 22, 8},
                    TerrainDistrict{"beyond_180_degrees", fiji, 27e3, 5e3, fijiMarch, 18, 11},
                    TerrainDistrict{"before_180_degrees", fiji, -27e3, 5e3, fijiMarch, 18, 11}),
    [](const auto& place) { return std::string(place.param.name); });

// Open sea from sunrise to sunset; the sun rises and sets at the horizon of the curved sea.
TEST(GeocentricSea, LiesInTheSunAllDayFarFromTheMiddleOfTheTerrain) {
    for (const glm::dvec2 off : {glm::dvec2(45e3, 0), glm::dvec2(-45e3, 0), glm::dvec2(0, 45e3)}) {
        const TerrainDistrict place{"sea", north62, off.x, off.y, march, 0, 24, true};
        const City city = cityOf(place, {});
        for (const char* engine : {"ray", "horizon"}) {
            const Study study = studyOf(place, city, engine);
            std::cout << "sea " << off.x << ' ' << off.y << ", " << engine << ": "
                      << study.statistics.meanGrossMin << " min, " << study.sun.steps.size() << " steps, "
                      << study.sun.levelled << " levelled\n";
            EXPECT_EQ(study.statistics.maxGrossMin, 0) << engine;
        }
    }
}

}  // namespace
}  // namespace noonmark::tests
