#include "core/io/files/check_output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include "core/io/write_city.h"
#include "core/samples/sample_city.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using namespace std::string_view_literals;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr std::string_view geoJson = R"({"type":"FeatureCollection","features":[]})";
constexpr std::string_view pngHead = "\x89PNG\r\n\x1a\n....";

class CheckOutput : public testing::Test {
protected:
    /// Why a file may not be written; empty if it may.
    static std::string why(const fs::path& file, OutputKind kind, const OutputRules& rules = {}) {
        const auto may = checkOutput(file, kind, rules);
        return may ? std::string() : may.error().text();
    }

    /// Why it may not be written, with and without permission to replace files.
    static std::string whyNever(const fs::path& file, OutputKind kind,
                                const std::vector<fs::path>& inputs = {}) {
        const std::string words = why(file, kind, {inputs, false});
        EXPECT_EQ(why(file, kind, {inputs, true}), words);
        return words;
    }

    /// A database with a table and the application id of a GeoPackage.
    fs::path database(const std::string& name, const char* sql) {
        const fs::path file = folder.path(name);
        sqlite3* made = nullptr;
        EXPECT_EQ(sqlite3_open(file.c_str(), &made), SQLITE_OK);
        EXPECT_EQ(sqlite3_exec(made, "PRAGMA application_id = 1196444487", nullptr, nullptr, nullptr),
                  SQLITE_OK);
        EXPECT_EQ(sqlite3_exec(made, sql, nullptr, nullptr, nullptr), SQLITE_OK);
        sqlite3_close(made);
        return file;
    }

    tests::TemporaryFolder folder;
};

TEST_F(CheckOutput, WhatIsNotThereMayBeWritten) {
    EXPECT_EQ(why(folder.path("new.gpkg"), OutputKind::geoPackage), "");
    EXPECT_EQ(why(folder.path("no/such/folder/new.gpkg"), OutputKind::geoPackage), "");
    EXPECT_EQ(why(folder.path("new.gpkg"), OutputKind::geoPackage, {{"sample:grid", "", "1,2,3,4"}, false}),
              "");
}

TEST_F(CheckOutput, WhatIsThereOfTheKindNeedsTheWord) {
    const fs::path city = folder.path("city.gpkg");
    ASSERT_TRUE(writeCityGeoPackage(city, makeCentralParkSouthSample()));
    EXPECT_EQ(
        why(city, OutputKind::geoPackage),
        city.string() +
            ": There is a file of this name already. Add --overwrite to replace it, or name another file");
    EXPECT_EQ(why(city, OutputKind::geoPackage, {{}, true}), "");
    const fs::path empty = folder.file("empty.gpkg", "");
    EXPECT_THAT(why(empty, OutputKind::geoPackage), HasSubstr("--overwrite"));
    EXPECT_EQ(why(empty, OutputKind::geoPackage, {{}, true}), "") << "nothing is lost";
}

TEST_F(CheckOutput, AnInputIsOneByAnyName) {
    const fs::path input = folder.file("houses.geojson", geoJson);
    const fs::path hard = folder.path("hard.geojson"), soft = folder.path("soft.geojson");
    fs::create_hard_link(input, hard);
    fs::create_symlink("houses.geojson", soft);
    const fs::path detour =
        folder.path("") / "." / ".." / folder.path("").parent_path().filename() / "houses.geojson";
    for (const fs::path& name : {input, hard, soft, detour})
        EXPECT_THAT(whyNever(name, OutputKind::geoJson, {input}), HasSubstr("is an input")) << name;
    EXPECT_THAT(whyNever(soft, OutputKind::geoJson, {input}),
                HasSubstr("the same file as " + input.string()));
    EXPECT_EQ(why(hard, OutputKind::geoJson, {{folder.file("other.geojson", geoJson)}, true}), "");
}

TEST_F(CheckOutput, CompanionsAndFoldersOfInputsAreInputs) {
    const fs::path shape = folder.file("city.SHP", "x"), terrain = folder.file("hills.tif", "II*\0"sv);
    EXPECT_THAT(whyNever(folder.file("city.dbf", "a,b\n"), OutputKind::table, {shape}),
                HasSubstr("read with " + shape.string()));
    EXPECT_THAT(whyNever(folder.file("hills.tfw", "a,b\n"), OutputKind::table, {terrain}),
                HasSubstr("is an input"));
    EXPECT_THAT(whyNever(folder.file("layer.json", "{}"), OutputKind::json, {folder.path("")}),
                HasSubstr("is an input"));
    EXPECT_THAT(why(folder.path("new.json"), OutputKind::json, {{folder.path("")}, false}),
                HasSubstr("folder is an input"));
    EXPECT_EQ(why(folder.path("out/new.json"), OutputKind::json, {{folder.path("")}, false}), "");
}

TEST_F(CheckOutput, AProjectIsKnownByItsContent) {
    const fs::path project =
        database("innocent.gpkg", "CREATE TABLE noonmark (id INTEGER, key TEXT, value TEXT)");
    const fs::path link = folder.path("shadow.tif");
    fs::create_symlink(project, link);
    EXPECT_THAT(whyNever(project, OutputKind::geoPackage), HasSubstr("is a Noonmark project"));
    EXPECT_THAT(whyNever(link, OutputKind::geoTiff), HasSubstr("is a Noonmark project"));
    EXPECT_THAT(why(project, OutputKind::project), HasSubstr("--overwrite"));
    EXPECT_EQ(why(project, OutputKind::project, {{}, true}), "");
    const fs::path plain = database("a.noonmark.gpkg", "CREATE TABLE buildings (fid INTEGER)");
    EXPECT_EQ(why(plain, OutputKind::geoPackage, {{}, true}), "") << "its name does not make it a project";
    EXPECT_THAT(whyNever(plain, OutputKind::project), HasSubstr("it is not a Noonmark project"));
}

TEST_F(CheckOutput, ADamagedOrBusyDatabaseIsLeftAlone) {
    const fs::path file = database("city.gpkg", "CREATE TABLE buildings (fid INTEGER)");
    fs::copy_file(file, folder.path("cut.gpkg"));
    fs::resize_file(folder.path("cut.gpkg"), 1000);
    EXPECT_NE(whyNever(folder.path("cut.gpkg"), OutputKind::geoPackage), "");
    (void)folder.file("city.gpkg-journal", "half a transaction");
    EXPECT_THAT(why(file, OutputKind::geoPackage, {{}, true}), HasSubstr("is writing to this file"));
    (void)folder.file("gone.gpkg-journal", "half a transaction");
    for (const OutputKind kind : {OutputKind::geoPackage, OutputKind::project})
        EXPECT_THAT(why(folder.path("gone.gpkg"), kind, {{}, true}), HasSubstr("remove the journal"))
            << "it would be applied to a new file of that name";
}

TEST_F(CheckOutput, AnotherKindIsNeverReplaced) {
    const fs::path words = folder.file("words", "Dear board, please find attached\n");
    for (const OutputKind kind :
         {OutputKind::geoPackage, OutputKind::geoJson, OutputKind::geoTiff, OutputKind::picture,
          OutputKind::pdf, OutputKind::movie, OutputKind::glb, OutputKind::json, OutputKind::project})
        EXPECT_THAT(whyNever(words, kind), HasSubstr("it is not " + std::string(describe(kind))));
    EXPECT_THAT(whyNever(folder.file("one column", "Dear board\n"), OutputKind::table), HasSubstr("CSV"));
    EXPECT_THAT(whyNever(folder.file("markup", "<svg a=\"1,2\">\n"), OutputKind::table), HasSubstr("CSV"));
    EXPECT_THAT(whyNever(folder.file("bytes", "a,b\n\0\0"sv), OutputKind::table), HasSubstr("CSV"));
    EXPECT_THAT(whyNever(folder.file("map", geoJson), OutputKind::json), HasSubstr("not JSON with figures"));
    EXPECT_THAT(whyNever(folder.file("figures", "{\"shadow\":1}"), OutputKind::geoJson),
                HasSubstr("not GeoJSON"));
}

TEST_F(CheckOutput, EveryKindKnowsItsOwn) {
    const auto replaces = [&](OutputKind kind, std::string_view content) {
        return why(folder.file("file", content), kind, {{}, true}).empty();
    };
    EXPECT_TRUE(replaces(OutputKind::geoJson, geoJson));
    EXPECT_TRUE(replaces(OutputKind::json, "\xEF\xBB\xBF [1, 2]"));
    EXPECT_TRUE(replaces(OutputKind::json, "{\"program\":\"Noonmark\"}"));
    EXPECT_TRUE(replaces(OutputKind::geoTiff, "II+\0\x08"sv));
    EXPECT_TRUE(replaces(OutputKind::picture, pngHead));
    EXPECT_TRUE(replaces(OutputKind::picture, "\xFF\xD8\xFF\xE0"));
    EXPECT_TRUE(replaces(OutputKind::pdf, "%PDF-1.4\n"));
    EXPECT_TRUE(replaces(OutputKind::table, "x_m,y_m\r\n0,1\r\n"));
    EXPECT_FALSE(replaces(OutputKind::geoTiff, pngHead));
}

// The copy of a city with figures that an earlier run wrote.
TEST_F(CheckOutput, ACopyOfTheCityReplacesItself) {
    EXPECT_EQ(detectOutputKind("elements.city.json"), OutputKind::cityJson);
    EXPECT_EQ(detectOutputKind("study.json"), OutputKind::json);
    const fs::path copy = folder.file("elements.city.json", R"({"type":"CityJSON","version":"2.0"})");
    EXPECT_EQ(why(copy, OutputKind::cityJson, {{}, true}), "");
    EXPECT_THAT(why(copy, OutputKind::cityJson, {{copy}, true}), HasSubstr("is an input"));
    EXPECT_THAT(whyNever(copy, OutputKind::json), HasSubstr("not JSON with figures"));
    EXPECT_THAT(whyNever(folder.file("study.json", R"({"shadow":1})"), OutputKind::cityJson),
                HasSubstr("not CityJSON"));
}

TEST_F(CheckOutput, WhatIsNoFileHasItsOwnMessage) {
    const fs::path pipe = folder.path("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(whyNever(pipe, OutputKind::table), HasSubstr("a pipe or a device"));
    EXPECT_THAT(whyNever("/dev/null", OutputKind::table), HasSubstr("a pipe or a device"));
    EXPECT_THAT(whyNever(folder.path(""), OutputKind::table), HasSubstr("A folder has this name"));
    fs::create_symlink("nowhere", folder.path("link"));
    EXPECT_THAT(whyNever(folder.path("link"), OutputKind::table),
                HasSubstr("a link to a file that does not exist"));
}

TEST_F(CheckOutput, OfSeveralTheWorstIsHeardFirst) {
    const std::vector<std::string> names{"shadow.tif", "shadow.png", "study.json"};
    const auto whyNot = [&](const OutputRules& rules) {
        const auto may = checkOutputs(folder.path(""), names, rules);
        return may ? std::string() : may.error().text();
    };
    EXPECT_EQ(whyNot({}), "");
    (void)folder.file("shadow.tif", "II*\0"sv);
    EXPECT_THAT(whyNot({}), HasSubstr("shadow.tif: There is a file of this name already. Add --overwrite"));
    (void)folder.file("shadow.png", pngHead);
    EXPECT_THAT(whyNot({}), HasSubstr("shadow.tif and 1 more of the files to write exist already"));
    EXPECT_EQ(whyNot({{}, true}), "");
    (void)folder.file("study.json", geoJson);
    EXPECT_THAT(whyNot({}),
                HasSubstr("study.json: There is a file of this name already, and it is not JSON"));
    EXPECT_EQ(whyNot({{}, true}), whyNot({}));
    EXPECT_EQ(findExistingOutputs(folder.path(""), {"shadow.png", "cells.csv"}),
              std::vector<std::string>{"shadow.png"});
}

}  // namespace
}  // namespace noonmark
