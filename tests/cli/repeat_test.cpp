#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "scenarios/project/project_file.h"
#include "tests/cli/command_output.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/box_obj.h"

// Runs the command that a result prints in an empty folder with copies of its inputs only, and compares all
// figures of both results exactly.
namespace noonmark::cli::tests {
namespace {

using noonmark::tests::readBytes;

namespace fs = std::filesystem;
using testing::HasSubstr;

// Heights in feet in a field with an unusual name; one building has levels only, one has no height.
constexpr const char* houses = R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"id":"north house","roof top":120,"building:levels":3},"geometry":{"type":"Polygon","coordinates":
 [[[-73.98410,40.75300],[-73.98382,40.75300],[-73.98382,40.75321],[-73.98410,40.75321],[-73.98410,40.75300]]]}},
{"type":"Feature","properties":{"id":"b","building:levels":7},"geometry":{"type":"Polygon","coordinates":
 [[[-73.98340,40.75300],[-73.98311,40.75300],[-73.98311,40.75322],[-73.98340,40.75322],[-73.98340,40.75300]]]}},
{"type":"Feature","properties":{"id":"c"},"geometry":{"type":"Polygon","coordinates":
 [[[-73.98405,40.75265],[-73.98370,40.75260],[-73.98370,40.75276],[-73.98405,40.75276],[-73.98405,40.75265]]]}}]})";

// An oblique triangle with a side longer than 500 m, which readRegion() subdivides.
constexpr const char* triangle =
    R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":
 [[[-73.98500,40.75240],[-73.97850,40.75262],[-73.98360,40.75353],[-73.98500,40.75240]]]}})";

constexpr const char* box = "-73.9845,40.7525,-73.9828,40.7536";

using Words = std::vector<std::string>;

Words joined(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// Splits a command line into words as a POSIX shell does.
Words asShellReads(const std::string& command) {
    const std::string script = "printf '%s\\0' " + command;
    const std::unique_ptr<FILE, int (*)(FILE*)> shell(::popen(script.c_str(), "r"), &::pclose);
    Words words;
    std::string word;
    for (int letter = 0; (letter = std::fgetc(shell.get())) != EOF;)
        if (letter != 0)
            word += char(letter);
        else
            words.push_back(std::exchange(word, {}));
    return words;
}

nlohmann::json jsonIn(const fs::path& file) {
    std::ifstream stream(file);
    EXPECT_TRUE(stream) << file;
    return nlohmann::json::parse(stream);
}

// All figures of a JSON file, without run times, the paths of the inputs, and whether the engine was named or
// chosen automatically.
nlohmann::json figuresIn(const fs::path& file) {
    nlohmann::json json = jsonIn(file);
    for (const char* key : {"seconds", "accumulate_seconds", "write_seconds", "mega_rays_per_s", "inputs",
                            "engine", "engine_settings", "region", "warnings"})
        json.erase(key);
    if (json.contains("error") && json["error"].is_object()) json["error"].erase("seconds");
    return json;
}

class Repeat : public testing::Test {
protected:
    void TearDown() override { fs::current_path(fs::temp_directory_path()); }

    static Words inMarch(Words words) {
        return joined(std::move(words), {"--start", "2026-03-21", "--hours", "6", "--step", "20", "--zone",
                                         "America/New_York", "--cell", "2"});
    }

    /// Runs a command, then the command that it printed, and expects the same figures. Returns the JSON.
    nlohmann::json repeated(Words words, const std::string& json, const std::vector<fs::path>& inputs) {
        const fs::path out = folder_.path("out");
        const CommandOutput first =
            noonmarkCli(joined(std::move(words), {"--overwrite", "--out", out.string()}));
        EXPECT_EQ(first.code, 0) << first.err;
        if (first.code != 0) return {};
        const nlohmann::json answer = jsonIn(out / json);
        const std::string command = answer["repeat"].is_string() ? answer["repeat"] : answer["repeat_note"];
        const noonmark::tests::TemporaryFolder empty;
        for (const fs::path& input : inputs) fs::copy_file(input, empty.path(input.filename().string()));
        if (command.find("region.geojson") != std::string::npos)
            fs::copy_file(out / "region.geojson", empty.path("region.geojson"));
        fs::current_path(empty.path(""));
        Words again = asShellReads(command);
        EXPECT_EQ(again.empty() ? "" : again.front(), "noonmark-cli") << command;
        if (!again.empty()) again.erase(again.begin());
        const CommandOutput second = noonmarkCli(again);
        EXPECT_EQ(second.code, 0) << command << "\n" << second.err;
        if (second.code == 0) {
            EXPECT_EQ(figuresIn(empty.path("repeated") / json), figuresIn(out / json)) << command;
        }
        fs::current_path(fs::temp_directory_path());
        return answer;
    }

    fs::path city() { return folder_.file("5th Ave's \"houses\" $1.geojson", houses); }
    fs::path region() { return folder_.file("place.geojson", triangle); }

    /// A project of the inputs: a scenario that changes two buildings, a scenario based on it, and a region.
    fs::path project() {
        const fs::path file = folder_.path("O'Brien plan.noonmark.gpkg");
        const auto done = [&](const Words& words) {
            const CommandOutput output = noonmarkCli(words);
            EXPECT_EQ(output.code, 0) << output.err;
        };
        done({"project", "new", file.string(), city().string(), "--height-field", "roof top", "--height-unit",
              "ft", "--region", "North's place=" + region().string()});
        done({"project", "add-scenario", file.string(), "Taller \"b\" & $HOME"});
        done({"project", "height", file.string(), "b", "--height", "60", "--scenario",
              "Taller \"b\" & $HOME"});
        done({"project", "demolish", file.string(), "c", "--scenario", "Taller \"b\" & $HOME"});
        done({"project", "add-scenario", file.string(), "--base", "Taller \"b\" & $HOME", "--", "--Last"});
        done({"project", "demolish", file.string(), "north house", "--scenario=--Last"});
        return file;
    }

    noonmark::tests::TemporaryFolder folder_;
};

TEST_F(Repeat, AStudyOfAFileReadWithOptions) {
    const auto json =
        repeated(inMarch({"study", city().string(), "--height-field", "roof top", "--height-unit", "ft",
                          "--metres-per-level", "2.9", "--default-height", "7.3", "--region", box}),
                 "study.json", {city()});
    EXPECT_TRUE(json["project"].is_null());
    EXPECT_EQ(json["read_settings"]["default_height_m"], 7.3);
    EXPECT_FALSE(fs::exists(folder_.path("out/region.geojson")));
}

TEST_F(Repeat, AStudyOfARegionThatIsAPolygon) {
    const auto json =
        repeated(inMarch({"study", city().string(), "--region", region().string()}), "study.json", {city()});
    EXPECT_THAT(json["repeat"].get<std::string>(), HasSubstr("--region region.geojson"));
}

TEST_F(Repeat, AStudyOfTheWholeCity) {
    const auto json =
        repeated(inMarch({"study", city().string(), "--region", "city"}), "study.json", {city()});
    EXPECT_THAT(json["repeat"].get<std::string>(), HasSubstr("--region city"));
}

TEST_F(Repeat, AStudyWithEveryOption) {
    repeated({"study",
              city().string(),
              "--region",
              "-73.98451234567,40.75250000001,-73.9828,40.7536",
              "--start",
              "2026-06-01",
              "--days",
              "3",
              "--window",
              "sunrise-30m..sunset-1.25h",
              "--centre",
              "--step",
              "7.5",
              "--zone",
              "Europe/Paris",
              "--no-refraction",
              "--cell",
              "1.7",
              "--receivers",
              "both",
              "--engine",
              "horizon",
              "--option",
              "bin=1.25",
              "--pressure",
              "890.5",
              "--temperature",
              "-7.25",
              "--error-sample",
              "60"},
             "study.json", {city()});
}

TEST_F(Repeat, AStudyOnRoofsInSunlightHours) {
    repeated({"study", city().string(), "--region", box, "--start", "2026-12-20", "--days", "2", "--window",
              "sunrise+1.5h..sunset-1.5h", "--step", "10", "--cell", "2", "--receivers", "roofs",
              "--no-error-sample"},
             "study.json", {city()});
}

TEST_F(Repeat, MonthsAndContributions) {
    repeated(inMarch({"study", city().string(), "--region", box, "--days", "40", "--by", "month",
                      "--contributions", "--engine", "horizon"}),
             "study.json", {city()});
}

TEST_F(Repeat, AMeshAndASample) {
    const fs::path mesh = folder_.file("tower.obj", noonmark::tests::boxObj(20, 30, 90));
    repeated(inMarch({"study", mesh.string(), "--up", "z", "--mesh-unit", "ft", "--mesh-north", "-28.9",
                      "--mesh-anchor", "-73.98371234567,40.7530", "--region", box}),
             "study.json", {mesh});
    repeated(inMarch({"study", "sample:central-park-south", "--region", "-73.9790,40.7650,-73.9770,40.7660"}),
             "study.json", {});
}

TEST_F(Repeat, TilesOfACityStudy) {
    const auto json =
        repeated(inMarch({"city-study", city().string(), "--region", region().string(), "--tile", "64"}),
                 "study.json", {city()});
    EXPECT_THAT(json["repeat"].get<std::string>(), HasSubstr("--tile 64"));
}

TEST_F(Repeat, AStudyOfAScenario) {
    const fs::path file = project();
    const auto json = repeated(
        inMarch({"study", file.string(), "--scenario", "Taller \"b\" & $HOME", "--region", "North's place"}),
        "study.json", {file});
    EXPECT_EQ(json["scenario"], "Taller \"b\" & $HOME");
    ASSERT_EQ(json["scenario_edits"].size(), 2U);
    EXPECT_THAT(json["scenario_edits"][1].get<std::string>(), HasSubstr("Demolish c"));
    EXPECT_EQ(json["project"]["file"], "O'Brien plan.noonmark.gpkg");
    EXPECT_TRUE(json["project"]["saved_as_measured"].get<bool>());
    EXPECT_EQ(json["project"]["file_sha256"], describeInputFile(file).value().sha256);
    EXPECT_EQ(json["read_settings"]["height_field"], "roof top");
    EXPECT_FALSE(json["warnings"].empty()) << "what was noted at `project new` belongs to the city";
    const auto existing =
        repeated(inMarch({"study", file.string(), "--region", "city"}), "study.json", {file});
    EXPECT_EQ(existing["scenario"], "Existing");
    EXPECT_NE(existing["scenario_city_sha256"], json["scenario_city_sha256"]);
    EXPECT_NE(existing["shadow_area_m2"], json["shadow_area_m2"]);
    repeated(inMarch({"study", file.string(), "--scenario=--Last", "--region", box}), "study.json", {file});
    repeated(inMarch({"city-study", file.string(), "--scenario=--Last", "--region", "North's place"}),
             "study.json", {file});
}

TEST_F(Repeat, AnImpact) {
    const fs::path file = project();
    const auto json = repeated({"impact",
                                file.string(),
                                "--from",
                                "Taller \"b\" & $HOME",
                                "--to=--Last",
                                "--region",
                                region().string(),
                                "--start",
                                "2026-03-21",
                                "--at",
                                "10:30",
                                "--hours",
                                "5",
                                "--step",
                                "15",
                                "--zone",
                                "America/New_York",
                                "--cell",
                                "2",
                                "--threshold",
                                "12.5",
                                "45",
                                "--by-building"},
                               "impact.json", {file});
    EXPECT_EQ(json["scenario"], "--Last");
    EXPECT_EQ(json["baseline"], "Taller \"b\" & $HOME");
    EXPECT_EQ(json["scenario_edits"].size(), 3U);
    EXPECT_EQ(json["baseline_edits"].size(), 2U);
    EXPECT_FALSE(json["warnings"].empty());
}

TEST_F(Repeat, AScore) {
    const fs::path file = project();
    ASSERT_EQ(noonmarkCli({"project", "period", "add", file.string(), "the year", "--start", "2026-01-01",
                           "--days", "365", "--window", "sunrise+1h..sunset-1h", "--step", "60"})
                  .code,
              0);
    const auto json = repeated({"score", file.string(), "--scenario", "Taller \"b\" & $HOME", "--region",
                                "North's place", "--period", "the year", "--cell", "4"},
                               "score.json", {file});
    EXPECT_EQ(json["scenario"], "Taller \"b\" & $HOME");
    EXPECT_THAT(json["repeat"].get<std::string>(), HasSubstr("--weights default"));
    repeated({"study", file.string(), "--scenario", "Taller \"b\" & $HOME", "--region", "North's place",
              "--period", "the year", "--cell", "4"},
             "study.json", {file});
}

TEST_F(Repeat, TheContentHashOutlastsASaveOfOtherThings) {
    const fs::path file = project();
    const Words words = inMarch({"study", file.string(), "--region", box, "--out",
                                 folder_.path("out").string(), "--overwrite", "--json"});
    const auto before = noonmarkCli(words).json();
    ASSERT_EQ(noonmarkCli({"project", "add-scenario", file.string(), "Unrelated"}).code, 0);
    const auto after = noonmarkCli(words).json();
    EXPECT_EQ(after["project"]["content_sha256"], before["project"]["content_sha256"]);
    EXPECT_NE(after["project"]["file_sha256"], before["project"]["file_sha256"]);
    const auto other = noonmarkCli(joined(words, {"--scenario=--Last"})).json();
    EXPECT_NE(other["project"]["content_sha256"], before["project"]["content_sha256"]);
}

TEST_F(Repeat, TablesNameTheirSource) {
    const fs::path file = project();
    const Words words{
        "--region", box,      "--start", "2026-03-21", "--at", "12:00", "--hours",
        "1",        "--step", "20",      "--zone",     "UTC",  "--out", folder_.path("out").string()};
    const CommandOutput impact = noonmarkCli(joined({"impact", file.string(), "--to=--Last"}, words));
    ASSERT_EQ(impact.code, 0) << impact.err;
    const std::string csv = readBytes(folder_.path("out/impact.csv"));
    EXPECT_THAT(csv, HasSubstr(",project,scenario,baseline,content_sha256\r\n"));
    const std::string hash = jsonIn(folder_.path("out/impact.json"))["project"]["content_sha256"];
    // With an apostrophe: a spreadsheet would take --Last for a formula (csvField()).
    EXPECT_THAT(csv, HasSubstr(",O'Brien plan.noonmark.gpkg,'--Last,Existing," + hash + "\r\n"));
}

TEST_F(Repeat, WhatDoesNotGoTogetherIsRefused) {
    const fs::path file = project();
    const auto refused = [&](Words words) {
        const CommandOutput output = noonmarkCli(
            joined(inMarch(std::move(words)), {"--region", box, "--out", folder_.path("o").string()}));
        EXPECT_EQ(output.code, 2);
        return output.err;
    };
    EXPECT_THAT(refused({"study", city().string(), "--scenario", "A"}), HasSubstr("Only a project"));
    EXPECT_THAT(refused({"study", file.string(), "--scenario", "A"}), HasSubstr("no such scenario"));
    EXPECT_THAT(refused({"study", file.string(), city().string()}), HasSubstr("cannot be combined"));
    EXPECT_THAT(refused({"study", file.string(), "--height-unit", "ft"}), HasSubstr("reading options"));
}

}  // namespace
}  // namespace noonmark::cli::tests
