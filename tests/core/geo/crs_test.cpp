#include <fmt/format.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>
#include <cmath>
#include <limits>

#include "core/base/gdal_calls.h"
#include "core/geo/crs.h"
#include "tests/core/io/open_watch.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {

namespace {

constexpr const char* geographic =
    R"(GEOGCS["x",DATUM["d",SPHEROID["s",6378137,298]{}],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])";
constexpr const char* projected =
    R"(PROJCS["x",GEOGCS["x",DATUM["d",SPHEROID["s",6378137,298]],PRIMEM["Greenwich",0],)"
    R"(UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],UNIT["m",1],EXTENSION["PROJ4","{}"]])";

std::vector<std::string> definitionsThatName(const std::string& file) {
    const std::string grids = fmt::format(R"(,EXTENSION["PROJ4_GRIDS","{}"])", file);
    const std::string bound = fmt::format("+proj=longlat +ellps=bessel +nadgrids={} +type=crs", file);
    const GdalCalls calls;
    OGRSpatialReference system;
    system.SetFromUserInput(bound.c_str());
    char* json = nullptr;
    system.exportToPROJJSON(&json, nullptr);
    std::vector<std::string> texts{
        "+init=" + file + ":x",
        "+proj=utm +zone=32 +init = " + file + ":x",
        bound,
        fmt::format("+proj=longlat +ellps=bessel +nadgrids=@null,@{} +type=crs", file),
        fmt::format("proj=longlat ellps=bessel nadgrids={} type=crs", file),
        fmt::format("+proj=longlat +ellps=bessel +nadgrids=\"{}\" +type=crs", file),
        fmt::format("+proj=utm +zone=32 +ellps=bessel +geoidgrids={} +vunits=m +type=crs", file),
        fmt::format(fmt::runtime(geographic), grids),
        fmt::format(fmt::runtime(projected), "+proj=longlat +ellps=bessel +nadgrids=" + file),
        fmt::format(fmt::runtime(projected), "+init=" + file + ":x"),
        json != nullptr ? json : ""};
    CPLFree(json);
    return texts;
}

TEST(CrsDefinition, ATextThatNamesAFileOpensNone) {
    const tests::TemporaryFolder folder;
    const std::string file = folder.file("canary", "<x> +proj=longlat +ellps=WGS84 <>").string();
    const std::vector<std::string> texts = definitionsThatName(file);
    const tests::OpenWatch watch(file);
    ASSERT_TRUE(watch.watching());
    for (const std::string& text : texts) {
        const auto made = CrsToLonLat::of(text);
        ASSERT_FALSE(made) << text;
        EXPECT_NE(made.error().what.find("names the file"), std::string::npos) << made.error().what;
        EXPECT_FALSE(watch.wasOpened()) << text;
    }
}

TEST(CrsDefinition, ProjOpensItsOwnFilesOnlyWhoeverAsks) {
    const tests::TemporaryFolder folder;
    const std::string file = folder.file("canary", "<x> +proj=longlat +ellps=WGS84 <>").string();
    const std::vector<std::string> texts = definitionsThatName(file);
    const tests::OpenWatch watch(file);
    const GdalCalls calls;
    for (const std::string& text : texts) {
        OGRSpatialReference system, degrees;
        system.SetFromUserInput(text.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get());
        degrees.SetWellKnownGeogCS("WGS84");
        const std::unique_ptr<OGRCoordinateTransformation> there(
            OGRCreateCoordinateTransformation(&system, &degrees));
        double x = 9, y = 50;
        if (there) there->Transform(1, &x, &y);
        EXPECT_FALSE(watch.wasOpened()) << text;
    }
}

TEST(CrsDefinition, AGridIsTakenFromProjsOwnFolderOnly) {
    EXPECT_TRUE(checkNamesNoFile("+proj=longlat +nadgrids=@null,proj.db"));
    EXPECT_TRUE(checkNamesNoFile("+proj=merc +a=6378137 +b=6378137 +nadgrids=@null +wktext"));
    for (const char* grid :
         {"/dev/ptmx", "../proj/proj.db", "~/proj.db", "./proj.db", "absent.gsb", "", "a,b"})
        EXPECT_FALSE(checkNamesNoFile(fmt::format("+proj=longlat +nadgrids={} +x", grid))) << grid;
    EXPECT_TRUE(CrsToLonLat::of(
        "+proj=merc +a=6378137 +b=6378137 +lat_ts=0 +units=m +nadgrids=@null +wktext +no_defs +type=crs"));
}

TEST(CrsDefinition, AnOldCodeIsACode) { EXPECT_TRUE(CrsToLonLat::of("+init=epsg:28992")); }

TEST(CrsDefinition, ALongTextIsRefusedWithItsLimit) {
    for (const char* begin : {"urn:ogc:def:crs:EPSG:", "+proj=longlat +a=", "GEOGCS[\""}) {
        const auto made = CrsToLonLat::of(begin + std::string(10'000'000, '1'));
        ASSERT_FALSE(made);
        EXPECT_NE(made.error().what.find("65,536"), std::string::npos);
        EXPECT_LT(made.error().text().size(), 500U);
    }
    EXPECT_LT(CrsToLonLat::of("x" + std::string(60'000, 'y')).error().text().size(), 500U);
}

LonLat convert(const std::string& crs, glm::dvec2 point) {
    return CrsToLonLat::of(crs).value().lonLat({&point, 1})[0];
}

TEST(CrsToLonLat, EverySpellingOfTheSameSystem) {
    for (const char* crs :
         {"EPSG:32618", "epsg:32618", "urn:ogc:def:crs:EPSG::32618", "urn:ogc:def:crs:EPSG:9.9:32618",
          "http://www.opengis.net/def/crs/EPSG/0/32618", "https://www.opengis.net/def/crs/EPSG/0/32618/"}) {
        const LonLat place = convert(crs, {500000, 4649776.22});  // the central meridian, 42 degrees north
        EXPECT_NEAR(place.lonDeg, -75, 1e-9) << crs;
        EXPECT_NEAR(place.latDeg, 42, 1e-5) << crs;
    }
}

TEST(CrsToLonLat, LongitudeComesFirst) {
    const LonLat place = convert("EPSG:4326", {-73.98, 40.75});
    EXPECT_NEAR(place.lonDeg, -73.98, 1e-9);
    EXPECT_NEAR(place.latDeg, 40.75, 1e-9);
}

// Several transformations serve S-JTSK: one of 6 m for both countries, and of 1 m for each. What
// gdaltransform says, whichever place was asked for before.
TEST(CrsToLonLat, KrovakTakesTheBestTransformationOfEachPlace) {
    struct Known {
        glm::dvec2 point;
        LonLat place;
    };
    for (const auto& [point, place] : {Known{{-261000, -1239000}, {21.2819054566669, 48.7263904578587}},
                                       Known{{-743000, -1043000}, {14.4185938905097, 50.087346614665}},
                                       Known{{-598000, -1160600}, {16.6099799867654, 49.1966339652947}},
                                       Known{{-573000, -1280000}, {17.1164444735587, 48.1521045154514}}}) {
        const LonLat found = convert("EPSG:5514", point);
        EXPECT_NEAR(found.lonDeg, place.lonDeg, 2e-8) << point.x;  // a millimetre
        EXPECT_NEAR(found.latDeg, place.latDeg, 2e-8) << point.x;
    }
}

TEST(CrsToLonLat, EastingsLoseTheNumberOfTheirZone) {
    for (const char* crs : {"EPSG:25833", "EPSG:25833+7837", "EPSG:32633"}) {
        auto system = CrsToLonLat::of(crs);
        system->removeZoneNumber();
        const glm::dvec2 plain{391800, 5820000}, numbered{33391800, 5820000};
        const LonLat place = system->lonLat({&plain, 1})[0];
        EXPECT_FALSE(system->hasRemovedZoneNumber()) << crs;
        const LonLat same = system->lonLat({&numbered, 1})[0];
        EXPECT_TRUE(system->hasRemovedZoneNumber()) << crs;
        EXPECT_EQ(same.lonDeg, place.lonDeg) << crs;
        EXPECT_EQ(same.latDeg, place.latDeg) << crs;
    }
    // Another zone's number is not taken off, and this system states its numbers itself.
    EXPECT_TRUE(std::isnan(convert("EPSG:25833", {32391800, 5820000}).lonDeg) ||
                !CrsToLonLat::of("EPSG:25833")->isPlausible(convert("EPSG:25833", {32391800, 5820000})));
    auto own = CrsToLonLat::of("EPSG:4647");
    own->removeZoneNumber();
    const glm::dvec2 point{32500000, 5820000};
    EXPECT_NEAR(own->lonLat({&point, 1})[0].lonDeg, 9, 1e-9);
    EXPECT_FALSE(own->hasRemovedZoneNumber());
}

TEST(CrsToLonLat, UnitsOfHeight) {
    const auto unit = [](const char* crs) {
        const auto made = CrsToLonLat::of(crs);
        return std::pair(made->metresPerElevationUnit(), made->elevationUnitIsStated());
    };
    EXPECT_EQ(unit("EPSG:7415"), std::pair(1.0, true));
    EXPECT_EQ(unit("EPSG:4979"), std::pair(1.0, true));
    EXPECT_EQ(unit("EPSG:28992"), std::pair(1.0, false));
    EXPECT_NEAR(unit("EPSG:2263+6360").first, 1200.0 / 3937, 1e-12);
    EXPECT_TRUE(unit("EPSG:2263+6360").second);
    EXPECT_EQ(unit("EPSG:2263+5703"), std::pair(1.0, true));
    EXPECT_NEAR(unit("EPSG:2263").first, 1200.0 / 3937, 1e-12);
    EXPECT_FALSE(unit("EPSG:2263").second);
}

TEST(CrsToLonLat, WhatIsNoPlaceIsNaN) {
    for (const glm::dvec2 point :
         {glm::dvec2(std::numeric_limits<double>::quiet_NaN(), 0), glm::dvec2(1e30, 1e30),
          glm::dvec2(std::numeric_limits<double>::infinity(), 5)})
        EXPECT_TRUE(std::isnan(convert("EPSG:32618", point).latDeg));
    EXPECT_TRUE(std::isnan(convert("EPSG:4326", {10, 95}).latDeg));
}

TEST(CrsToLonLat, KnowsWhereItIsUsed) {
    const auto dutch = CrsToLonLat::of("EPSG:28992");
    EXPECT_TRUE(dutch->isPlausible({4.9, 52.4}));
    EXPECT_FALSE(dutch->isPlausible({-73.98, 40.75}));
    EXPECT_FALSE(dutch->isPlausible({std::nan(""), std::nan("")}));
    EXPECT_TRUE(CrsToLonLat::of("EPSG:4326")->isPlausible({179, -80}));
    // New Zealand's area of use crosses the date line
    EXPECT_TRUE(CrsToLonLat::of("EPSG:2193")->isPlausible({-179, -40}));
}

TEST(CrsToLonLat, WhatIsNoSystemIsAnError) {
    for (const char* crs : {"", "EPSG:0", "EPSG:999999", "hello", "EPSG:5709", "http://example.com/crs"}) {
        const auto made = CrsToLonLat::of(crs);
        ASSERT_FALSE(made) << crs;
        EXPECT_FALSE(made.error().advice.empty());
    }
}

}  // namespace

}  // namespace noonmark
