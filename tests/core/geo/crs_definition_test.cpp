#include "core/geo/crs.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include "core/base/gdal_calls.h"
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

}  // namespace
}  // namespace noonmark
