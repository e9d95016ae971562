#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/cli/command_output.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/shared_data.h"

namespace noonmark::cli::tests {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// One oneHouse of 20 m near Bryant Park.
constexpr const char* oneHouse = R"({"type":"FeatureCollection","features":[
{"type":"Feature","id":1,"properties":{"name":"A","height":"20"},"geometry":{"type":"Polygon","coordinates":
 [[[-73.9840,40.7530],[-73.9837,40.7530],[-73.9837,40.7532],[-73.9840,40.7532],[-73.9840,40.7530]]]}}]})";
// On its southern wall, inside it, and without a height.
constexpr const char* windows = R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"id":"south"},"geometry":{"type":"Point","coordinates":[-73.98385,40.7530,4]}},
{"type":"Feature","properties":{"id":"inside","azimuth":180},"geometry":{"type":"Point","coordinates":[-73.98385,40.7531,4]}},
{"type":"Feature","properties":{"id":"flat"},"geometry":{"type":"Point","coordinates":[-73.98385,40.7530]}}]})";

std::string writtenText(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::ostringstream content;
    content << stream.rdbuf();
    return content.str();
}

class StudyPoints : public testing::Test {
protected:
    CommandOutput study(const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"study",       folder_.file("city.geojson", oneHouse).string(),
                                           "--start",     "2026-03-21",
                                           "--window",    "sunrise..sunset",
                                           "--step",      "10",
                                           "--zone",      "America/New_York",
                                           "--region",    "-73.9845,40.7527,-73.9826,40.7537",
                                           "--overwrite", "--out",
                                           out_.string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return noonmarkCli(arguments);
    }

    noonmark::tests::TemporaryFolder folder_;
    std::filesystem::path out_ = folder_.path("out");
    std::string windows_ = folder_.file("windows.geojson", windows).string();
};

TEST_F(StudyPoints, WindowsOfAnIfcStandWhereItsMeshWasAnchored) {
    const auto house = noonmark::tests::sharedData("world/FZK.ifc");
    if (!house) GTEST_SKIP() << "shared data is missing";
    const CommandOutput output = noonmarkCli({"study",         house->string(),
                                              "--mesh-anchor", "-73.984,40.753",
                                              "--mesh-north",  "15",
                                              "--start",       "2026-03-21",
                                              "--window",      "sunrise..sunset",
                                              "--step",        "10",
                                              "--zone",        "America/New_York",
                                              "--region",      "-73.985,40.752,-73.983,40.754",
                                              "--out",         out_.string(),
                                              "--json",        "--receivers",
                                              "windows",       "--windows",
                                              house->string()});
    ASSERT_EQ(output.code, exitOk) << output.err;
    EXPECT_EQ(output.json()["receivers"], 13);
    EXPECT_THAT(writtenText(out_ / "elements.csv"), HasSubstr("EG-Fenster-1,window,FZK-Haus,"));
}

TEST_F(StudyPoints, FacadesAreTablesAndAGeoPackage) {
    const CommandOutput output =
        study({"--receivers", "facades", "--facades-of", "A", "--storey", "4", "--json"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    const auto json = output.json();
    EXPECT_EQ(json["elements"]["receivers_on"], "facades");
    EXPECT_GT(json["receivers"], 5 * 4);
    const std::string csv = writtenText(out_ / "elements.csv");
    EXPECT_THAT(csv, StartsWith("id,kind,building,building_name,floor,azimuth_deg,lon_deg,lat_deg,"));
    EXPECT_EQ(std::ranges::count(csv, '\n'), json["receivers"].get<int>() + 1);
    EXPECT_TRUE(std::filesystem::exists(out_ / "elements.gpkg"));
    EXPECT_THAT(writtenText(out_ / "elements.glb"), StartsWith("glTF"));
    EXPECT_THAT(json["repeat"].get<std::string>(),
                HasSubstr("--receivers facades --facades-of A --storey 4"));
    // The points that it wrote are windows that it reads, with the same answer.
    const std::string elements = (out_ / "elements.gpkg").string();
    out_ = folder_.path("again");
    const CommandOutput again = study({"--receivers", "windows", "--windows", elements, "--json"});
    ASSERT_EQ(again.code, exitOk) << again.err;
    EXPECT_EQ(again.json()["receivers"], json["receivers"]);
    EXPECT_NEAR(again.json()["mean_sunlit_min"].get<double>(), json["mean_sunlit_min"].get<double>(), 0.5);
}

TEST_F(StudyPoints, WindowsThatCannotBeMeasuredAreListed) {
    const CommandOutput output = study({"--receivers", "windows", "--windows", windows_, "--json"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    EXPECT_EQ(output.json()["receivers"], 1);
    EXPECT_THAT(output.json()["elements"]["windows"][0]["sha256"].get<std::string>(), testing::SizeIs(64));
    const std::string warnings = output.json()["warnings"].dump();
    EXPECT_THAT(warnings, HasSubstr("has no height"));
    EXPECT_THAT(warnings, HasSubstr("inside a building"));
    const CommandOutput table = study({"--receivers", "windows", "--windows", windows_});
    EXPECT_THAT(table.out, testing::ContainsRegex("\npoints +1\n"));
    EXPECT_THAT(table.out, testing::ContainsRegex("receivers on +windows\n"));
    EXPECT_THAT(table.out, HasSubstr("inside a building"));
}

TEST_F(StudyPoints, TheFileOfWindowsIsNotReplaced) {
    out_ = folder_.path("out");
    std::filesystem::create_directories(out_);
    std::filesystem::copy_file(windows_, out_ / "elements.csv");
    const CommandOutput output =
        study({"--receivers", "windows", "--windows", (out_ / "elements.csv").string()});
    EXPECT_EQ(output.code, exitUsage);
    EXPECT_EQ(writtenText(out_ / "elements.csv"), writtenText(windows_));
}

TEST_F(StudyPoints, OptionsThatDoNotBelongAreRefused) {
    EXPECT_EQ(study({"--receivers", "windows"}).code, exitUsage);
    EXPECT_EQ(study({"--windows", windows_}).code, exitUsage);
    EXPECT_EQ(study({"--facades-of", "A"}).code, exitUsage);
    EXPECT_EQ(study({"--plane-height", "4", "--receivers", "facades"}).code, exitUsage);
    EXPECT_EQ(study({"--receivers", "facades", "--cells-csv"}).code, exitUsage);
    EXPECT_EQ(study({"--receivers", "facades", "--engine", "sam"}).code, exitFailed);
    EXPECT_EQ(study({"--receivers", "facades", "--facades-of", "B"}).code, exitUsage);
    EXPECT_EQ(study({"--receivers", "windows", "--windows", "missing.gpkg"}).code, exitUsage);
    EXPECT_EQ(noonmarkCli({"city-study", "sample:grid", "--receivers", "facades"}).code, exitUsage);
}

TEST_F(StudyPoints, NamedBuildingsNeedNoRegion) {
    const auto withoutRegion = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"study",       folder_.file("city.geojson", oneHouse).string(),
                                           "--start",     "2026-03-21",
                                           "--zone",      "UTC",
                                           "--receivers", "facades",
                                           "--out",       out_.string(),
                                           "--json",      "--overwrite"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return noonmarkCli(arguments);
    };
    const std::vector<std::string> named{"--facades-of", "A", "--from", "14:00"};
    const CommandOutput output = withoutRegion(named);
    ASSERT_EQ(output.code, exitOk) << output.err;
    const std::string repeat = output.json()["repeat"].get<std::string>();
    EXPECT_THAT(repeat, HasSubstr("--region "));
    EXPECT_EQ(withoutRegion({"--facades-of", "all"}).code, exitUsage) << "all of which region?";
    EXPECT_EQ(withoutRegion({}).code, exitUsage);
}

TEST_F(StudyPoints, FacesOfADirectionAreChosen) {
    const CommandOutput all = study({"--receivers", "facades", "--json"});
    const CommandOutput south = study({"--receivers", "facades", "--facing", "135-225", "--json"});
    ASSERT_EQ(south.code, exitOk) << south.err;
    // The building is 25 m wide and 22 m deep: 8 and 7 bays.
    EXPECT_EQ(south.json()["receivers"].get<int>() * 30, all.json()["receivers"].get<int>() * 8);
    EXPECT_EQ(south.json()["elements"]["facing_deg"][0], 135);
    EXPECT_THAT(south.json()["repeat"].get<std::string>(), HasSubstr("--facing 135-225"));
    const std::string csv = writtenText(out_ / "elements.csv");
    const std::size_t id = csv.find('\n') + 1;
    const std::string face = csv.substr(id, csv.find(" floor", id) - id);
    const CommandOutput one = study({"--receivers", "facades", "--face", face, "--json"});
    ASSERT_EQ(one.code, exitOk) << one.err;
    EXPECT_EQ(one.json()["receivers"], south.json()["receivers"]);
    EXPECT_EQ(study({"--receivers", "facades", "--facing", "south"}).code, exitUsage);
    EXPECT_EQ(study({"--receivers", "plane", "--facing", "135-225"}).code, exitUsage);
    EXPECT_EQ(study({"--receivers", "facades", "--facing-place", "Park"}).code, exitUsage);
    EXPECT_EQ(study({"--receivers", "facades", "--within", "50"}).code, exitUsage);
    EXPECT_EQ(study({"--receivers", "facades", "--facades-of", "proposed"}).code, exitUsage);
}

TEST_F(StudyPoints, LinesAroundAParcelAtTheirDistances) {
    const std::string parcel =
        folder_
            .file("parcel.geojson",
                  R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},)"
                  R"("geometry":{"type":"Polygon","coordinates":[[[-73.9841,40.7529],)"
                  R"([-73.9836,40.7529],[-73.9836,40.7533],[-73.9841,40.7533],[-73.9841,40.7529]]]}}]})")
            .string();
    const CommandOutput output = study({"--receivers", "lines", "--parcel", parcel, "--offsets", "5,10",
                                        "--plane-height", "4", "--spacing", "2", "--json"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    const auto json = output.json();
    // 42.2 x 44.4 m, and a circle of 5 and of 10 m, in parts of 2 m.
    EXPECT_NEAR(json["receivers"].get<double>(), (2 * 173.2 + 31.4 + 62.8) / 2, 4);
    EXPECT_EQ(json["elements"]["offsets_m"].dump(), "[5.0,10.0]");
    EXPECT_EQ(json["elements"]["plane_above_ground_m"], 4);
    EXPECT_THAT(json["repeat"].get<std::string>(), HasSubstr("--offsets 5,10"));
    EXPECT_THAT(writtenText(out_ / "elements.csv"), HasSubstr("\n\"5 m, 1\",point,,,,,-73.98"));
    EXPECT_EQ(study({"--receivers", "lines"}).code, exitUsage);
    EXPECT_EQ(study({"--receivers", "facades", "--parcel", parcel}).code, exitUsage);
    EXPECT_EQ(study({"--receivers", "lines", "--parcel", "missing.geojson"}).code, exitUsage);
}

TEST_F(StudyPoints, SinglePointsOfAFileOrTheCommandLine) {
    const std::string file =
        folder_
            .file("points.csv",
                  "id,lon,lat,height,facing\nyard,-73.9842,40.7531,,\nwall,-73.98385,40.75299,4,180\n")
            .string();
    const CommandOutput read = study({"--receivers", "points", "--points", file, "--json"});
    ASSERT_EQ(read.code, exitOk) << read.err;
    EXPECT_EQ(read.json()["receivers"], 2);
    EXPECT_EQ(read.json()["elements"]["points"][1]["facing_deg"], 180);
    const std::string csv = writtenText(out_ / "elements.csv");
    EXPECT_THAT(csv, HasSubstr("\nyard,point,"));
    EXPECT_THAT(csv, HasSubstr("\nwall,point,,,,180."));
    const CommandOutput given = study({"--receivers", "points", "--point", "-73.9842,40.7531", "--point",
                                       "-73.98385,40.75299,4,180", "--json"});
    ASSERT_EQ(given.code, exitOk) << given.err;
    EXPECT_NEAR(given.json()["mean_sunlit_min"].get<double>(), read.json()["mean_sunlit_min"].get<double>(),
                1e-3);
    EXPECT_EQ(study({"--receivers", "points"}).code, exitUsage);
    EXPECT_EQ(study({"--receivers", "points", "--point", "1"}).code, exitUsage);
    EXPECT_EQ(study({"--receivers", "points", "--points", "missing.csv"}).code, exitUsage);
}

TEST_F(StudyPoints, APlaneAboveTheGround) {
    const CommandOutput output =
        study({"--receivers", "plane", "--plane-height", "4", "--cell", "5", "--json"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    EXPECT_EQ(output.json()["elements"]["plane_above_ground_m"], 4);
    EXPECT_THAT(output.json()["repeat"].get<std::string>(), HasSubstr("--receivers plane --plane-height 4"));
    EXPECT_THAT(writtenText(out_ / "elements.csv"), HasSubstr(",plane,,,,,-73.98"));
}

}  // namespace
}  // namespace noonmark::cli::tests
