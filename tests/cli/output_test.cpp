#include "tests/cli/project_command.h"

// No command overwrites its input, a project, or a file of another kind.
namespace noonmark::cli::tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* house = R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"height":20},"geometry":{"type":"Polygon","coordinates":
 [[[-73.9840,40.7530],[-73.9837,40.7530],[-73.9837,40.7532],[-73.9840,40.7532],[-73.9840,40.7530]]]}}]})";

constexpr const char* place = R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":
 [[[-73.9845,40.7527],[-73.9826,40.7527],[-73.9830,40.7537],[-73.9845,40.7527]]]}})";

using noonmark::tests::readBytes;
using Words = std::vector<std::string>;

class OutputGuard : public ProjectCommand {
protected:
    /// Runs a command that must be refused and must leave `victim` and the folder unchanged. Returns the
    /// error.
    std::string saved(const fs::path& victim, const Words& words) {
        const std::string before = readBytes(victim);
        const auto names = folder_.names();
        const CommandOutput output = noonmarkCli(words);
        EXPECT_EQ(output.code, exitUsage) << output.out << output.err;
        EXPECT_TRUE(readBytes(victim) == before) << victim << ": " << output.err;
        EXPECT_EQ(folder_.names(), names);
        return output.err;
    }

    /// The same, also with --overwrite, which must make no difference.
    std::string keptAlways(const fs::path& victim, const Words& words) {
        std::string why = saved(victim, plus(words, {"--overwrite"}));
        EXPECT_EQ(saved(victim, words), why);
        return why;
    }

    static Words atNine(Words words, const fs::path& out) {
        return plus(std::move(words),
                    {"--start", "2026-03-21", "--from", "09:00", "--hours", "1", "--step", "30", "--zone",
                     "America/New_York", "--cell", "5", "--out", out.string()});
    }

    Words studyOf(const std::string& region) {
        return atNine({"study", city_.string(), "--region", region}, folder_.path("out"));
    }

    static constexpr const char* box_ = "-73.9845,40.7527,-73.9826,40.7537";
    fs::path city_ = folder_.file("houses.geojson", house);
    fs::path out_ = folder_.path("out");
};

TEST_F(OutputGuard, AProjectKeepsItsScenarios) {
    ASSERT_EQ(project("add-scenario", {"Mine"}).code, 0);
    const fs::path copy = folder_.path("innocent.gpkg");
    fs::copy_file(file_, copy);
    EXPECT_THAT(keptAlways(file_, {"project", "export", file_, "--out", file_}), HasSubstr("is an input"));
    for (const fs::path& victim : {fs::path(file_), copy}) {
        const std::string out = victim.string();
        EXPECT_THAT(keptAlways(victim, {"import", city_.string(), "--out", out}),
                    HasSubstr("is a Noonmark project"));
        EXPECT_THAT(keptAlways(victim, {"sample", "grid", "--out", out}), HasSubstr("is a Noonmark project"));
    }
    EXPECT_THAT(keptAlways(copy, {"project", "export", file_, "--out", copy.string()}),
                HasSubstr("is a Noonmark project"));
    EXPECT_THAT(saved(file_, {"project", "new", file_, city_.string()}), HasSubstr("--overwrite"));
    EXPECT_EQ(opened().scenarios.size(), 1U);
    EXPECT_EQ(noonmarkCli({"project", "new", file_, city_.string(), "--overwrite"}).code, exitOk);
    EXPECT_TRUE(opened().scenarios.empty());
}

TEST_F(OutputGuard, ASourceStaysWhatItIs) {
    const fs::path link = folder_.path("link.geojson"), twin = folder_.path("twin.geojson");
    fs::create_symlink(city_, link);
    fs::create_hard_link(city_, twin);
    for (const fs::path& out : {city_, link, twin})
        EXPECT_THAT(keptAlways(city_, {"import", city_.string(), "--out", out.string()}),
                    HasSubstr("is an input"));
    EXPECT_THAT(keptAlways(city_, {"project", "new", city_.string(), city_.string()}),
                HasSubstr("is an input"));
    const fs::path park = folder_.file("park.geojson", place);
    EXPECT_THAT(keptAlways(park, {"project", "new", park.string(), city_.string(), "--region",
                                  "Park=" + park.string()}),
                HasSubstr("is an input"));
    EXPECT_TRUE(fs::is_symlink(link));
}

TEST_F(OutputGuard, TheFilesOfAProjectsCityAreInputsOfItsExport) {
    const fs::path city = folder_.path("city.gpkg"), own = folder_.path("own.noonmark.gpkg");
    ASSERT_EQ(noonmarkCli({"import", city_.string(), "--out", city.string()}).code, exitOk);
    ASSERT_EQ(noonmarkCli({"project", "new", own.string(), city.string()}).code, exitOk);
    EXPECT_THAT(keptAlways(city, {"project", "export", own.string(), "--out", city.string()}),
                HasSubstr("is an input"));
}

TEST_F(OutputGuard, OnlyTheSameKindIsReplacedAndOnlyWhenAsked) {
    const fs::path notes = folder_.file("notes.gpkg", "Dear board\n"), city = folder_.path("city.gpkg");
    EXPECT_THAT(keptAlways(notes, {"sample", "grid", "--out", notes.string()}),
                HasSubstr("it is not a GeoPackage"));
    EXPECT_THAT(keptAlways(notes, {"project", "new", notes.string(), city_.string()}),
                HasSubstr("it is not a Noonmark project"));
    EXPECT_THAT(keptAlways(notes, {"import", city_.string(), "--out", out_.parent_path().string()}),
                HasSubstr("A folder has this name"));
    const Words import{"import", city_.string(), "--out", city.string()};
    ASSERT_EQ(noonmarkCli(import).code, exitOk);
    EXPECT_THAT(saved(city, import), HasSubstr("Add --overwrite to replace it, or name another file"));
    EXPECT_EQ(noonmarkCli(plus(import, {"--overwrite"})).code, exitOk);
}

TEST_F(OutputGuard, AStudyIsNotReplacedUnasked) {
    ASSERT_EQ(noonmarkCli(studyOf(box_)).code, exitOk);
    const Words again = studyOf(box_);
    EXPECT_THAT(saved(out_ / "study.json", again), HasSubstr("shadow.tif and 4 more of the files to write"));
    // The check precedes reading the city, which does not exist here.
    EXPECT_THAT(saved(out_ / "study.json", atNine({"study", "/no/such.geojson", "--region", box_}, out_)),
                HasSubstr("--overwrite"));
    EXPECT_EQ(noonmarkCli(plus(again, {"--overwrite"})).code, exitOk);
    EXPECT_EQ(noonmarkCli(plus(again, {"--overwrite", "--cells-csv"})).code, exitOk);
    std::ofstream(out_ / "cells.csv") << "no table";
    EXPECT_THAT(keptAlways(out_ / "cells.csv", plus(again, {"--cells-csv"})),
                HasSubstr("it is not a CSV table"));
    fs::remove(out_ / "shadow.tif");
    fs::create_hard_link(file_, out_ / "shadow.tif");
    EXPECT_THAT(keptAlways(file_, again), HasSubstr("is a Noonmark project"));
}

TEST_F(OutputGuard, ARegionInTheFolderIsAnInput) {
    ASSERT_EQ(noonmarkCli(studyOf(folder_.file("park.geojson", place).string())).code, exitOk);
    const fs::path region = out_ / "region.geojson";
    ASSERT_TRUE(fs::exists(region));
    EXPECT_THAT(saved(region, plus(studyOf(region.string()), {"--overwrite"})), HasSubstr("is an input"));
    fs::remove(out_ / "shadow.tif");
    for (const char* name : {"shadow.qml", "shadow.png", "report.pdf", "study.json"}) fs::remove(out_ / name);
    EXPECT_THAT(saved(region, studyOf(folder_.path("park.geojson").string())),
                HasSubstr("region.geojson: There is a file of this name already"));
    EXPECT_EQ(noonmarkCli(studyOf(box_)).code, exitOk) << "a box needs no file";
}

TEST_F(OutputGuard, AFinishedCityStudyIsNotReplacedUnasked) {
    const Words words = atNine({"city-study", city_.string(), "--region", box_}, out_);
    ASSERT_EQ(noonmarkCli(words).code, exitOk);
    EXPECT_THAT(saved(out_ / "shadow.tif", words), HasSubstr("shadow.tif and 2 more"));
    EXPECT_EQ(noonmarkCli(plus(words, {"--overwrite"})).code, exitOk);
}

TEST_F(OutputGuard, AnImpactAndAScoreAreNotReplacedUnasked) {
    const auto asked = [&](const char* command) {
        Words words{command,   file_,         "--region", "Park",       "--cell", "10",
                    "--out",   out_.string(), "--start",  "2026-12-21", "--at",   "12:00",
                    "--hours", "1",           "--step",   "30",         "--zone", "America/New_York"};
        if (command == std::string("impact")) words.insert(words.end(), {"--to", "Existing"});
        return words;
    };
    for (const std::string command : {"impact", "score"}) {
        ASSERT_EQ(noonmarkCli(asked(command.c_str())).code, exitOk) << command;
        const fs::path json = out_ / (command + ".json");
        EXPECT_THAT(saved(json, asked(command.c_str())), HasSubstr(command + ".tif and 5 more"));
        EXPECT_EQ(noonmarkCli(plus(asked(command.c_str()), {"--overwrite"})).code, exitOk) << command;
        std::ofstream(json) << house;
        EXPECT_THAT(keptAlways(json, asked(command.c_str())), HasSubstr("it is not JSON with figures"));
    }
}

}  // namespace
}  // namespace noonmark::cli::tests
