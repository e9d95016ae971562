#include "core/io/terrain/ground_choice.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/engines/ray/ray_scene.h"
#include "core/io/read_city.h"
#include "tests/core/io/city_reading.h"
#include "tests/core/io/footprint_files.h"
#include "tests/core/io/source_surface.h"
#include "tests/core/io/terrain_files.h"
#include "tests/shared/shared_data.h"

namespace noonmark::tests {
namespace {

// A row of two houses and one alone, 8, 11 and 15 m high, on ground that rises by 1 in 10 to the east.
struct House {
    Ring outline;
    double heightM;
};
std::vector<House> houses() {
    return {{sizedRectangle(-60, 0, 12, 20), 8},
            {sizedRectangle(-48, 0, 12, 20), 11},
            {sizedRectangle(20, -40, 25, 16), 15}};
}

double ground(double x, double /*y*/) { return 50 + x / 10; }

// Roofs are level, at their height above the ground at the middle of the building.
double surface(double x, double y) {
    for (const House& house : houses()) {
        const Box2 box = bounds(house.outline);
        if (contains({house.outline, {}}, {x, y}))
            return ground(double(box.low.x + box.high.x) / 2, 0) + house.heightM;
    }
    return ground(x, y);
}

class SurfaceModel : public tests::CityReading {
protected:
    std::filesystem::path outlines(bool withHeights = true) {
        std::string features;
        for (const House& house : houses())
            features +=
                (features.empty() ? "" : ",") +
                feature(house.outline, withHeights ? fmt::format(R"("height":{})", house.heightM) : "");
        return folder.file("houses.geojson", R"({"type":"FeatureCollection","features":[)" + features + "]}");
    }
    std::filesystem::path dsm() { return writeTerrain(folder.path("dsm.tif"), manhattan, surface); }
    std::filesystem::path dtm() { return writeTerrain(folder.path("dtm.tif"), manhattan, ground); }
    static bool warns(const CityRead& read, std::string_view what) {
        return std::ranges::any_of(
            read.warnings, [&](const Warning& one) { return one.what.find(what) != std::string::npos; });
    }
    static double elevation(const City& city, float z) { return city.frame.originElevationM() + double(z); }

    void expectSameGround(const CityRead& one, const CityRead& other, double toleranceM) {
        ASSERT_EQ(one.city.buildings.size(), other.city.buildings.size());
        for (std::size_t i = 0; i < one.city.buildings.size(); ++i) {
            EXPECT_NEAR(elevation(one.city, one.city.buildings[i]->parts[0].bottomM),
                        elevation(other.city, other.city.buildings[i]->parts[0].bottomM), toleranceM);
            EXPECT_NEAR(elevation(one.city, topM(*one.city.buildings[i])),
                        elevation(other.city, topM(*other.city.buildings[i])), toleranceM);
        }
        for (double y = -150; y <= 150; y += 5)
            for (double x = -150; x <= 150; x += 5)
                EXPECT_NEAR(elevation(one.city, groundAt(one.city, {x, y})),
                            elevation(other.city, groundAt(other.city, {x, y})), toleranceM)
                    << x << ' ' << y;
    }

    TemporaryFolder folder;
};

TEST_F(SurfaceModel, TheGroundAroundTheOutlinesReplacesItsRoofs) {
    const CityRead onSurface = read({outlines(), dsm()}), onGround = read({outlines(), dtm()});
    EXPECT_TRUE(warns(onSurface, "steps at the outlines"));
    EXPECT_GT(onSurface.city.terrain->source.underBuildings, 800U);
    EXPECT_FALSE(warns(onGround, "steps"));
    EXPECT_EQ(onGround.city.terrain->source.underBuildings, 0U);
    expectSameGround(onSurface, onGround, 0.7);  // interpolated under a house on a slope
}

// Crowns 8 m wide and 10 m high, 20 m apart, between and over the houses.
double surfaceWithTrees(double x, double y) {
    const double east = std::remainder(x, 20), north = std::remainder(y, 20);
    return std::hypot(east, north) < 4 ? std::max(surface(x, y), ground(x, y) + 10) : surface(x, y);
}

TEST_F(SurfaceModel, TreesAreNoGround) {
    const auto model = writeTerrain(folder.path("trees.tif"), manhattan, surfaceWithTrees);
    expectSameGround(read({outlines(), model}), read({outlines(), dtm()}), 0.8);
}

TEST_F(SurfaceModel, TheUserMayUseItUnchanged) {
    settings.terrainShows = TerrainShows::ground;
    const CityRead read = this->read({outlines(), dsm()});
    EXPECT_EQ(read.city.terrain->source.underBuildings, 0U);
    const glm::dvec2 roof = read.city.frame.localFromLonLat(Frame(manhattan).lonLatFromLocal({32, -32}));
    EXPECT_NEAR(elevation(read.city, groundAt(read.city, roof)), surface(32, -32), 0.1);
}

TEST_F(SurfaceModel, BesideATerrainItIsNotTheGround) {
    const CityRead expected = read({outlines(), dtm()});
    for (const auto& files : {std::vector{outlines(), dsm(), dtm()}, {dtm(), dsm(), outlines()}}) {
        const CityRead read = this->read(files);
        EXPECT_EQ(read.city.terrain->source.file, "dtm.tif");
        EXPECT_TRUE(warns(read, "the other terrain is the ground"));
        expectSameGround(read, expected, 0.02);
    }
}

// Houses on a steep slope, as in a village in the Alps.
TEST_F(SurfaceModel, ASlopeIsNone) {
    const auto steep = [](double x, double y) { return 500 + 0.5 * x + 0.3 * y; };
    const CityRead read = this->read({outlines(), writeTerrain(folder.path("alp.tif"), manhattan, steep)});
    EXPECT_FALSE(warns(read, "steps"));
    EXPECT_EQ(read.city.terrain->source.underBuildings, 0U);
}

TEST_F(SurfaceModel, GivesHeightsToHousesWithoutAny) {
    EXPECT_TRUE(warns(read({outlines(false), dsm()}), "--heights-from-surface"));
    settings.heightsFromSurface = true;
    for (const auto& files : {std::vector{outlines(false), dsm(), dtm()}, {outlines(false), dsm()}}) {
        const CityRead read = this->read(files);
        EXPECT_FALSE(warns(read, "no height in the data")) << "they have one now";
        EXPECT_FALSE(warns(read, "no field of heights"));
        for (std::size_t i = 0; i < 3; ++i) {
            const Part& part = read.city.buildings.at(i)->parts[0];
            const Box2 box = bounds(houses()[i].outline);
            const double roof =
                surface(double(box.low.x + box.high.x) / 2, double(box.low.y + box.high.y) / 2);
            EXPECT_NEAR(elevation(read.city, part.topM), roof, 0.5);
            EXPECT_EQ(part.heightSource, HeightSource::measured);
        }
    }
}

double planArea(const Building& building) {
    double sum = 0;
    for (const Part& part : building.parts) sum += area(part.footprint);
    return sum;
}

// The row is one building of two heights, and the second from the south. Cells are 0.85 by 1.11 m: outlines
// are off by half of one at most.
TEST_F(SurfaceModel, WithoutOutlinesItMakesTheBuildings) {
    const CityRead made = read({dtm(), dsm()});
    EXPECT_TRUE(warns(made, "no file has outlines"));
    EXPECT_EQ(made.city.terrain->source.file, "dtm.tif");
    ASSERT_EQ(made.city.buildings.size(), 2);
    const double alone = planArea(*made.city.buildings[0]), row = planArea(*made.city.buildings[1]);
    EXPECT_NEAR(alone, 25 * 16, 25 + 16);
    EXPECT_NEAR(row, 24 * 20, 24 + 20);
    for (const House& house : houses()) {
        const Box2 box = bounds(house.outline);
        const double x = double(box.low.x + box.high.x) / 2, y = double(box.low.y + box.high.y) / 2;
        const glm::dvec2 at = made.city.frame.localFromLonLat(Frame(manhattan).lonLatFromLocal({x, y}));
        const RayHit roof =
            RayScene::over(made.city).value().firstHit(glm::vec3(at, 500), {0, 0, -1}).value();
        EXPECT_NEAR(elevation(made.city, 500 - roof.distanceM), surface(x, y), 0.01);
    }
}

TEST_F(SurfaceModel, AsGroundItMakesNoBuildings) {
    settings.terrainShows = TerrainShows::ground;
    NoProgress quiet;
    const auto read = readCity({dtm(), dsm()}, settings, quiet, {});
    EXPECT_TRUE(!read || read->city.buildings.empty());
}

TEST_F(SurfaceModel, OtherZerosAreRefusedOrSaid) {
    NoProgress quiet;
    const auto raised = [&](double byM) {
        return writeTerrain(folder.path("raised.tif"), manhattan,
                            [byM](double x, double y) { return surface(x, y) + byM; });
    };
    const auto refused = readCity({dtm(), raised(30)}, settings, quiet, {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("lies 30.0 m above"), std::string::npos) << refused.error().text();
    EXPECT_TRUE(warns(read({dtm(), raised(1)}), "may count from different zeros"));
    EXPECT_FALSE(warns(read({dtm(), raised(0)}), "may count from different zeros"));
}

// A block that is built on but for a court of one in a hundred of its cells.
TEST_F(SurfaceModel, ACourtShowsTheGroundOfAFullBlock) {
    const auto full = [](double x, double y) {
        return ground(x, y) + (std::abs(x) < 17 && std::abs(y) < 22 ? 0 : 20);
    };
    const CityRead made = read({dtm(), writeTerrain(folder.path("full.tif"), manhattan, full)});
    EXPECT_EQ(made.city.buildings.size(), 1);
    EXPECT_FALSE(warns(made, "may count from different zeros"));
}

TEST_F(SurfaceModel, CellsWithoutElevationAreNoBuildings) {
    const auto holed = [](double x, double y) {
        return std::abs(x - 32) < 4 && std::abs(y + 32) < 4 ? std::nan("") : surface(x, y);
    };
    const CityRead made = read({dtm(), writeTerrain(folder.path("holed.tif"), manhattan, holed)});
    EXPECT_TRUE(warns(made, "cells without elevation in the surface model"));
    ASSERT_EQ(made.city.buildings.size(), 2);
    EXPECT_NEAR(planArea(*made.city.buildings[0]), 25 * 16 - 8 * 8, 25 + 16);
}

// Each half of the surface is a file of its own, without elevations in the other half. The third file is
// neither: heights above the ground, which some surveys deliver beside both.
TEST_F(SurfaceModel, SeveralSurfacesOverOneGroundAreAllTaken) {
    const auto half = [&](const char* name, bool east) {
        return writeTerrain(folder.path(name), manhattan, [east](double x, double y) {
            return (x > 0) == east ? surface(x, y) : std::nan("");
        });
    };
    const auto above = writeTerrain(folder.path("above.tif"), manhattan,
                                    [](double x, double y) { return surface(x, y) - ground(x, y); });
    const CityRead made = read({above, half("west.tif", false), half("east.tif", true), dtm()});
    ASSERT_EQ(made.city.buildings.size(), 2);
    EXPECT_EQ(made.city.buildings[0]->sourceId, "surface 1");
    EXPECT_EQ(made.city.buildings[1]->sourceId, "surface 2");
    EXPECT_EQ(made.city.terrain->source.file, "dtm.tif");
    EXPECT_TRUE(warns(made, "neither dtm.tif nor a surface above it"));
    EXPECT_FALSE(warns(made, "an earlier one covers"));
}

// In the later year the row is 6 m higher: the surface before it is no ground of it.
TEST_F(SurfaceModel, ASecondSurfaceOfOnePlaceMakesNoSecondBuildings) {
    const auto grown = [](double x, double y) {
        return surface(x, y) + (surface(x, y) > ground(x, y) + 1 && x < 0 ? 6 : 0);
    };
    const auto later = writeTerrain(folder.path("later.tif"), manhattan, grown);
    const CityRead made = read({dsm(), later, dtm()});
    EXPECT_EQ(made.city.terrain->source.file, "dtm.tif");
    ASSERT_EQ(made.city.buildings.size(), 2);
    EXPECT_NEAR(elevation(made.city, topM(*made.city.buildings[0])), surface(32, -32), 0.5);
    EXPECT_TRUE(warns(made, "cells of a surface model that an earlier one covers"));
}

// The ground begins 169 m east of the surface's western border, in the middle between row and house.
TEST_F(SurfaceModel, WhatLiesBeyondTheGroundIsNoBuildingAndSaid) {
    const auto shifted = [](double x, double y) { return ground(x + 168.9, y); };
    const auto east =
        writeTerrain(folder.path("east.tif"), {manhattan.lonDeg + 200e-5, manhattan.latDeg}, shifted);
    const CityRead made = read({dsm(), east});
    ASSERT_EQ(made.city.buildings.size(), 1);
    EXPECT_NEAR(planArea(*made.city.buildings[0]), 25 * 16, 25 + 16);
    const auto said = std::ranges::find(
        made.warnings, "cells of the surface model beyond the ground's border", &Warning::what);
    ASSERT_NE(said, made.warnings.end());
    EXPECT_EQ(said->where, "dsm.tif: 80,000 cells") << "half of 400 x 400";
}

TEST_F(SurfaceModel, CountsWhatIsInTheCity) {
    const auto saidOf = [](const CityRead& read) {
        const auto made = std::ranges::find_if(
            read.warnings, [](const Warning& one) { return one.what.starts_with("no file has outlines"); });
        return made == read.warnings.end() ? "" : made->where;
    };
    const CityRead whole = read({dtm(), dsm()});
    EXPECT_TRUE(saidOf(whole).starts_with("dsm.tif above dtm.tif: 2 buildings of 3 parts, cells of "))
        << saidOf(whole);
    EXPECT_EQ(whole.heights.fields.at(0).features, 2);
    settings.extent = LonLatBox{-73.97985, 40.7490, -73.9790, 40.7499};
    const CityRead part = read({dtm(), dsm()});
    EXPECT_TRUE(saidOf(part).starts_with("dsm.tif above dtm.tif: 1 building of 1 part, cells of "))
        << saidOf(part);
    EXPECT_EQ(part.heights.fields.at(0).features, 1);
}

/// Stops a reading when it makes buildings.
class StopAtBuildings final : public Progress {
public:
    void report(double fraction, std::string_view stage) override {
        if (stage != "making buildings of the surface model") return;
        reached = fraction;
        source.request_stop();
    }
    std::stop_source source;
    double reached = 0;
};

TEST_F(SurfaceModel, SaysItsProgressAndCanBeStopped) {
    StopAtBuildings progress;
    const auto read = readCity({dtm(), dsm()}, settings, progress, progress.source.get_token());
    ASSERT_FALSE(read);
    EXPECT_TRUE(isCancelled(read.error()));
    EXPECT_GE(progress.reached, 2.0 / 3) << "after the two files";
}

// As tiles read it, beside files of buildings.
TEST_F(SurfaceModel, AGroundAloneIsReadWithAnExtentElsewhere) {
    settings.extent = LonLatBox{10, 50, 11, 51};
    EXPECT_TRUE(read({dtm()}).city.terrain);
}

TEST_F(SurfaceModel, TheExtentChoosesAmongFilesAndWhatIsMade) {
    settings.extent =
        LonLatBox{-73.97985, 40.7490, -73.9790, 40.7499};  // the building 20 m to the east alone
    for (const auto& files : {std::vector{outlines(), dtm()}, {dtm(), dsm()}}) {
        const CityRead read = this->read(files);
        EXPECT_EQ(read.city.buildings.size(), 1);
        EXPECT_EQ(read.city.terrain->grid.columns, 400) << "the terrain stays whole";
    }
    settings.extent = LonLatBox{10, 50, 11, 51};
    NoProgress quiet;
    EXPECT_FALSE(readCity({outlines(), dtm()}, settings, quiet, {}));
}

/// The cells of a city's rasters as boxes, marched over in steps; shares no code with readers and engines.
class RasterMarch {
public:
    RasterMarch(const std::filesystem::path& dsm, const std::filesystem::path& dtm, const Frame& frame) {
        surface_ = valuesOf(dsm, frame), ground_ = valuesOf(dtm, frame);
    }
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    double groundAt(glm::ivec2 cell) const { return ground_[indexOf(cell)]; }
    /// 2 m and more stand there.
    bool isRaised(glm::ivec2 cell) const { return surface_[indexOf(cell)] - ground_[indexOf(cell)] >= 2; }
    glm::dvec2 placeOf(glm::dvec2 cell) const { return corner_ + local_ * cell; }

    /// Whether what is raised, lifted by `liftM`, is hit from a place `asideM` to the right of a cell's
    /// middle.
    bool blocks(glm::ivec2 cell, glm::dvec3 toSun, double asideM, double liftM) const {
        const double level = glm::length(glm::dvec2(toSun));
        const glm::dvec2 way = glm::dvec2(toSun) / level;
        const glm::dvec2 from = placeOf(glm::dvec2(cell)) + asideM * glm::dvec2(way.y, -way.x);
        const glm::dmat2 cellsPerM = glm::inverse(local_);
        for (double far = 0; far < 400; far += 0.05) {
            const glm::ivec2 at(glm::floor(cellsPerM * (from + far * way - corner_) + 0.5));
            if (at.x < 0 || at.y < 0 || at.x >= columns_ || at.y >= rows_) return false;
            if (isRaised(at) && surface_[indexOf(at)] + liftM > groundAt(cell) + far * toSun.z / level)
                return true;
        }
        return false;
    }

private:
    std::size_t indexOf(glm::ivec2 cell) const {
        return std::size_t(cell.y) * std::size_t(columns_) + std::size_t(cell.x);
    }
    std::vector<double> valuesOf(const std::filesystem::path& file, const Frame& frame) {
        const SourceSurface posts(file, frame.origin().lonDeg, frame.origin().latDeg,
                                  frame.originElevationM());
        columns_ = posts.columns(), rows_ = posts.rows();
        corner_ = glm::dvec2(posts.post(0, 0));
        local_[0] = (glm::dvec2(posts.post(columns_ - 1, 0)) - corner_) / double(columns_ - 1);
        local_[1] = (glm::dvec2(posts.post(0, rows_ - 1)) - corner_) / double(rows_ - 1);
        std::vector<double> values;
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column) values.push_back(posts.post(column, row).z);
        return values;
    }

    int columns_ = 0, rows_ = 0;
    glm::dvec2 corner_{};  // the middle of the first cell
    glm::dmat2 local_{};   // metres per column and per row
    std::vector<double> surface_, ground_;
};

// A cell counts at a sun if its shadow is the same 0.5 m to both sides, and with all that is raised 0.6 m
// higher and lower: the tolerance of heights, and what a slope of the ground between two posts makes.
TEST_F(SurfaceModel, GoteborgWithoutOutlinesCastsTheShadowsOfItsRaster) {
    const auto dsm = sharedData("goteborg/DSM_KRbig.tif"), dtm = sharedData("goteborg/DEM_KRbig.tif");
    if (!dsm || !dtm) GTEST_SKIP() << "shared data is missing";
    const CityRead made = read({*dsm, *dtm});
    const RayScene scene = RayScene::over(made.city).value();
    const RasterMarch march(*dsm, *dtm, made.city.frame);
    std::size_t all = 0, sure = 0, shaded = 0, same = 0;
    for (int row = 4; row < march.rows(); row += 9)
        for (int column = 4; column < march.columns(); column += 9)
            for (const auto& [azimuthDeg, altitudeDeg] : {std::array{135.0, 12.0},
                                                          {180.0, 9.0},
                                                          {180.0, 32.0},
                                                          {225.0, 25.0},
                                                          {250.0, 50.0},
                                                          {290.0, 15.0}}) {
                const glm::ivec2 cell(column, row);
                if (march.isRaised(cell)) break;
                const double azimuth = Degrees{azimuthDeg}.radians().value,
                             altitude = Degrees{altitudeDeg}.radians().value;
                const glm::dvec3 toSun(std::sin(azimuth) * std::cos(altitude),
                                       std::cos(azimuth) * std::cos(altitude), std::sin(altitude));
                ++all;
                const bool expected = march.blocks(cell, toSun, 0, 0);
                bool isSure = true;
                for (const double aside : {-0.5, 0.0, 0.5})
                    for (const double lift : {-0.6, 0.6})
                        isSure = isSure && march.blocks(cell, toSun, aside, lift) == expected;
                if (!isSure) continue;
                ++sure;
                shaded += expected ? 1 : 0;
                const glm::dvec2 at = march.placeOf(glm::dvec2(cell));
                const glm::vec3 from(at, double(groundAt(made.city, at)) + 0.02);
                same += scene.occluded(from, glm::vec3(toSun)) == expected ? 1 : 0;
            }
    std::printf(
        "Goteborg by its rasters: %zu buildings, %zu of %zu cells and suns are sure (%zu in shadow), %zu "
        "agree\n",
        made.city.buildings.size(), sure, all, shaded, same);
    EXPECT_GE(sure, 1000U);
    EXPECT_GE(double(sure), 0.8 * double(all));
    EXPECT_GE(double(std::min(shaded, sure - shaded)), 0.1 * double(sure));
    EXPECT_GE(double(same), 0.99 * double(sure));
}

}  // namespace
}  // namespace noonmark::tests
