#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/engines/shade_trees.h"
#include "core/io/read_city.h"
#include "core/io/trees/read_trees.h"
#include "tests/core/engines/sweep_scenes.h"
#include "tests/core/io/source_surface.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/shared_data.h"

// Trees of real data: Gothenburg's canopy raster among its buildings and on its ground, and the trees that
// OpenStreetMap maps in Bryant Park.
namespace noonmark::tests {
namespace {

City weighed(City city) {
    Trees trees = *city.trees;
    trees.weighed = true;
    city.trees = std::make_shared<const Trees>(std::move(trees));
    return city;
}

// Every half hour of each fifth day of a year, from 9:00 to 17:00.
SunSteps someOfAYear(const City& city, const char* zone, double stepMinutes = 30) {
    Period period;
    period.start = {std::chrono::year{2026}, std::chrono::January, std::chrono::day{1}};
    period.days = 365;
    period.hours = 8;
    period.stepMinutes = stepMinutes;
    period.zone = zone;
    const LonLat place = city.frame.origin();
    const SunSteps year = computeSunSteps(period, {.place = {place.lonDeg, place.latDeg}}).value();
    std::vector<std::size_t> days;
    for (std::size_t day = 0; day < year.days.size(); day += 5) days.push_back(day);
    return chooseDays(year, days);
}

/// What trees take of the sunlit time at each receiver.
std::vector<double> takenShares(const ShadowField& field, TreeColumns column, const Receivers& receivers) {
    std::vector<double> shares;
    for (const std::uint32_t cell : receivers.cells)
        shares.push_back(
            (double(fieldOfColumn(field, column).grossMin[cell]) - double(field.grossMin[cell])) /
            field.sunlitMinutesPerDay);
    return shares;
}

struct Off {
    double mean = 0, p99 = 0;
};

Off compare(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> off;
    for (std::size_t i = 0; i < a.size(); ++i) off.push_back(std::abs(a[i] - b[i]));
    std::ranges::sort(off);
    Off made{.p99 = off[off.size() * 99 / 100]};
    for (const double one : off) made.mean += one / double(off.size());
    return made;
}

double meanOf(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value / double(values.size());
    return sum;
}

std::optional<City> readGoteborg() {
    const auto dsm = sharedData("goteborg/DSM_KRbig.tif"), dtm = sharedData("goteborg/DEM_KRbig.tif"),
               canopy = sharedData("goteborg/CDSM_KRbig.tif");
    if (!dsm || !dtm || !canopy) return std::nullopt;
    NoProgress quiet;
    return weighed(readCity({*dsm, *dtm}, {.treeFiles = {canopy->string()}}, quiet, {}).value().city);
}

/// The cells of the canopy raster as boxes of 1 m, from a quarter of their height up to their top, marched
/// through in steps of 2 cm; shares no code with readers and engines. As dense by the metre as a medium crown
/// of 10 m: 10 % pass the mean chord of an ellipsoid of 7.14 m across and 7.5 m high, which is 4.84 m by
/// Cauchy's 4 x volume / surface, the surface by rotation of an ellipse.
class CanopyMarch {
public:
    explicit CanopyMarch(const Frame& frame)
        : canopy_(*sharedData("goteborg/CDSM_KRbig.tif"), frame.origin().lonDeg, frame.origin().latDeg, 0),
          ground_(*sharedData("goteborg/DEM_KRbig.tif"), frame.origin().lonDeg, frame.origin().latDeg,
                  frame.originElevationM()) {
        const double columns = canopy_.columns() - 1, rows = canopy_.rows() - 1;
        corner_ = glm::dvec2(canopy_.post(0, 0));
        local_[0] = (glm::dvec2(canopy_.post(canopy_.columns() - 1, 0)) - corner_) / columns;
        local_[1] = (glm::dvec2(canopy_.post(0, canopy_.rows() - 1)) - corner_) / rows;
        cellsPerM_ = glm::inverse(local_);
    }

    double takes(glm::dvec3 from, glm::dvec3 toSun) const {
        constexpr double pieceM = 0.02, medium = 2.302585 / 4.84;
        double pathM = 0;
        for (double far = pieceM / 2; far < 120; far += pieceM)
            if (isInside(from + far * toSun)) pathM += pieceM;
        return 1 - std::exp(-medium * pathM);
    }

private:
    bool isInside(glm::dvec3 place) const {
        const glm::ivec2 at(glm::floor(cellsPerM_ * (glm::dvec2(place) - corner_) + 0.5));
        if (at.x < 0 || at.y < 0 || at.x >= canopy_.columns() || at.y >= canopy_.rows()) return false;
        const double heightM = canopy_.post(at.x, at.y).z, aboveM = place.z - ground_.post(at.x, at.y).z;
        return heightM >= 2 && aboveM >= heightM / 4 && aboveM <= heightM;
    }

    SourceSurface canopy_, ground_;
    glm::dvec2 corner_{};
    glm::dmat2 local_{}, cellsPerM_{};
};

// Square cells and round columns of the same area differ by single rays, and by some percent in the mean
// where rays run along diagonals of the raster, as receivers 4 m apart stand at the same places of its cells.
TEST(RealTrees, GoteborgsCanopyTakesWhatItsRasterTakes) {
    const auto city = readGoteborg();
    if (!city) GTEST_SKIP() << "shared data is missing";
    const CanopyMarch march(city->frame);
    const Receivers receivers = receiversOver(*city, -80, -80, 80, 80, 4);
    for (const Sun sun : {Sun{135, 25}, {197, 32}, {225, 20}, {250, 50}}) {
        const ShadowField field = traced(*city, receivers, oneDay({sun}));
        ASSERT_TRUE(field.trees);
        std::vector<double> found, expected;
        for (const std::uint32_t cell : receivers.cells) {
            if (field.grossMin[cell] > 0) continue;  // in the shadow of a building
            found.push_back(double(field.trees->evergreen->grossMin[cell]));
            expected.push_back(march.takes(glm::dvec3(receivers.position(cell)),
                                           glm::dvec3(towardsSun(sun.azimuthDeg, sun.altitudeDeg))));
        }
        ASSERT_GT(found.size(), 100U);
        EXPECT_GT(meanOf(expected), 0.03) << "of the sun is taken";
        EXPECT_NEAR(meanOf(found), meanOf(expected), 0.05 * meanOf(expected)) << sun.azimuthDeg;
        EXPECT_LT(compare(found, expected).mean, 0.1 * meanOf(expected)) << sun.azimuthDeg;
    }
}

TEST(RealTrees, GoteborgsCanopyBySweepIsThatByRays) {
    const auto city = readGoteborg();
    if (!city) GTEST_SKIP() << "shared data is missing";
    const Receivers receivers = receiversOver(*city, -80, -80, 80, 80, 4);
    const SunSteps sun = someOfAYear(*city, "Europe/Stockholm");
    NoProgress quiet;
    const ShadowField rays = traced(*city, receivers, sun),
                      sweep = HorizonSweep({.counts = ShadowCounts::gross})
                                  .accumulate(*city, receivers, sun, quiet, {})
                                  .value();
    ASSERT_TRUE(rays.trees && sweep.trees);
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal}) {
        const auto exact = takenShares(rays, column, receivers),
                   found = takenShares(sweep, column, receivers);
        const Off off = compare(found, exact);
        std::printf(
            "Goteborg, %s: trees take %.2f %%, the sweep is off by %.3f %% in the mean, %.2f %% p99\n",
            suffixOf(column).c_str(), 100 * meanOf(exact), 100 * off.mean, 100 * off.p99);
        EXPECT_GT(meanOf(exact), 0.01);
        EXPECT_LT(off.mean, 0.001);
        EXPECT_LT(off.p99, 0.01);
    }
}

/// Midtown with the trees that OpenStreetMap maps in Bryant Park, and the park's receivers.
struct BryantPark {
    City city;
    Receivers receivers;
};

std::optional<BryantPark> readBryantPark() {
    const auto map = sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
    if (!map) return std::nullopt;
    NoProgress quiet;
    City city = weighed(readCity({*map}, {}, quiet, {}).value().city);
    const Region park = makeRegionFromLonLatBox(city.frame, -73.98455, 40.75325, -73.98305, 40.75435).value();
    Receivers receivers = placeReceiversOnGround(city, park, {6}).value();
    return BryantPark{std::move(city), std::move(receivers)};
}

TEST(RealTrees, BryantParksYearWithAndWithoutItsPlanes) {
    auto park = readBryantPark();
    if (!park) GTEST_SKIP() << "shared data is missing";
    const SunSteps sun = someOfAYear(park->city, "America/New_York", 10);
    NoProgress quiet;
    const auto sweepOf = [&](const City& city) {
        return HorizonSweep({.counts = ShadowCounts::gross})
            .accumulate(city, park->receivers, sun, quiet, {})
            .value();
    };
    const ShadowField rays = traced(park->city, park->receivers, sun), sweep = sweepOf(park->city);
    ASSERT_TRUE(rays.trees && sweep.trees);
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal}) {
        const auto exact = takenShares(rays, column, park->receivers);
        const Off off = compare(takenShares(sweep, column, park->receivers), exact);
        std::printf(
            "Bryant Park, %s: trees take %.2f %%, the sweep is off by %.3f %% in the mean, %.2f %% p99\n",
            suffixOf(column).c_str(), 100 * meanOf(exact), 100 * off.mean, 100 * off.p99);
        EXPECT_GT(meanOf(exact), 0.05);
        EXPECT_LT(off.mean, 0.001);
        EXPECT_LT(off.p99, 0.01);
    }
    Trees others = *park->city.trees;
    std::erase_if(others.trees, [&](const Tree& tree) {
        const Box2 box{{park->receivers.grid.westM - 20, park->receivers.grid.southM - 60},
                       {park->receivers.grid.westM + 160, park->receivers.grid.southM + 160}};
        return tree.place.x > box.low.x && tree.place.x < box.high.x && tree.place.y > box.low.y &&
               tree.place.y < box.high.y;
    });
    City bare = park->city;
    bare.trees = std::make_shared<const Trees>(std::move(others));
    const ShadowField felled = sweepOf(bare);
    for (const std::uint32_t cell : park->receivers.cells)
        EXPECT_EQ(felled.grossMin[cell], sweep.grossMin[cell]) << "buildings are the same";
    if (felled.trees) {
        EXPECT_LT(meanOf(takenShares(felled, TreeColumns::evergreen, park->receivers)),
                  0.1 * meanOf(takenShares(sweep, TreeColumns::evergreen, park->receivers)));
    }
}

// The same trees in an inventory as New York's: planes with stems of 20 inches. 20 x 2.54 cm x 25.5 = 12.95 m
// of crown, 1.4 x as high.
TEST(RealTrees, AnInventoryInInchesMakesThePlanesLarger) {
    auto park = readBryantPark();
    if (!park) GTEST_SKIP() << "shared data is missing";
    std::string rows = "tree_dbh,spc_latin,latitude,longitude\n";
    for (const Tree& tree : park->city.trees->trees) {
        const LonLat place = park->city.frame.lonLatFromLocal(tree.place);
        rows += fmt::format("20,Platanus x acerifolia,{:.8f},{:.8f}\n", place.latDeg, place.lonDeg);
    }
    TemporaryFolder folder;
    const auto file = folder.file("inventory.csv", rows);
    NoProgress quiet;
    City bare = park->city;
    bare.trees.reset();
    Warnings warnings;
    const auto read = readTrees(file, {}, quiet, {}).value();
    City inches = bare;
    inches.trees = joinTrees(read.trees, bare, 50'000, warnings);
    inches = weighed(std::move(inches));
    ASSERT_EQ(inches.trees->trees.size(), park->city.trees->trees.size());
    for (const Tree& tree : inches.trees->trees) {
        ASSERT_NEAR(tree.crownDiameterM, 12.95, 0.01);
        ASSERT_NEAR(tree.heightM, 18.14, 0.01);
        ASSERT_EQ(tree.crownSource, TreeSource::estimated);
    }
    const SunSteps sun = someOfAYear(inches, "America/New_York", 60);
    const auto taken = [&](const City& city) {
        return meanOf(
            takenShares(traced(city, park->receivers, sun), TreeColumns::seasonal, park->receivers));
    };
    EXPECT_GT(taken(inches), 1.2 * taken(park->city));
}

}  // namespace
}  // namespace noonmark::tests
