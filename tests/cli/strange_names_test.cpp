#include <fmt/format.h>

#include "tests/cli/project_command.h"

namespace noonmark::cli::tests {

namespace {

// A name that clears a terminal's window, and adds a line.
const std::string strange = "Tower\x1b[2J\nfalse line\u009Bm\u202E";

bool isCommand(unsigned char c) { return (c < 0x20 && c != '\n' && c != '\t') || c == 0x7F; }

void expectClean(const std::vector<std::string>& words) {
    const CommandOutput output = noonmarkCli(words);
    const std::string all = output.out + "\n" + output.err;
    EXPECT_EQ(std::ranges::count_if(all, isCommand), 0) << testing::PrintToString(words) << all;
    for (const char* mark : {"\nfalse", "\u009B", "\u202E"})
        EXPECT_EQ(all.find(mark), std::string::npos) << testing::PrintToString(words) << all;
}

class StrangeNames : public ProjectCommand {
protected:
    void SetUp() override {
        ProjectCommand::SetUp();
        auto disk = ProjectFile::open(file_).value();
        Project project = disk.project();
        project.lots.at(0).name = strange;
        project.scenarios.push_back({strange, "", {}});
        project.regions.push_back({strange, project.regions.at(0).polygons});
        project.places.push_back({strange, PlaceKind::park, project.regions.at(0).polygons, strange});
        project.weights.push_back(makeMonthlyWeights());
        project.weights.back().name = strange;
        project.weights.back().intervals.at(0).name = strange;
        project.periods.push_back({strange, {}});
        City city = *project.city;
        Building tower = *city.buildings.at(0);
        tower.name = tower.sourceId = tower.status = strange;
        city.buildings.at(0) = std::make_shared<const Building>(tower);
        project.city = std::make_shared<const City>(city);
        ASSERT_TRUE(disk.save(project));
    }

    std::string city_ =
        folder_
            .file("city.geojson", fmt::format(R"({{"type":"FeatureCollection","features":[
{{"type":"Feature","properties":{{"id":{0},"name":{0},"leisure":"park","height":"20 {1}"}},"geometry":
{{"type":"Polygon","coordinates":[[[0.000,0.000],[0.001,0.000],[0.001,0.001],[0.000,0.001],[0.000,0.000]]]}}}},
{{"type":"Feature","properties":{{"id":{0},"name":{0},"leisure":"park","height":"20 {1}"}},"geometry":
{{"type":"Polygon","coordinates":[[[0.002,0.000],[0.003,0.001],[0.003,0.000],[0.002,0.001],[0.002,0.000]]]}}}}]}})",
                                              nlohmann::json(strange).dump(), "\\u001b[2J\\nfalse"))
            .string();
};

TEST_F(StrangeNames, OfAProjectSendNoCommandsToATerminal) {
    for (const char* command :
         {"info", "lot list", "region list", "place list", "weights list", "period list"}) {
        std::vector<std::string> words{"project"};
        std::istringstream stream(command);
        for (std::string word; stream >> word;) words.push_back(word);
        words.push_back(file_);
        expectClean(words);
        words.emplace_back("--json");
        expectClean(words);
    }
    expectClean({"info", file_});
    expectClean({"project", "weights", "show", file_, "no such table"});
    expectClean({"study", file_, "--region", "no such region", "--out", folder_.path("o").string()});
    expectClean({"study", file_, "--scenario", "no such scenario", "--out", folder_.path("o").string()});
    expectClean(
        {"point", file_, "--at", "-73.9785,40.7675,1.5", "--zone", "America/New_York", "--step", "60"});
    expectClean({"timeline", file_, "--place", "all", "--day", "2026-12-21", "--at", "12:00", "--hours", "1",
                 "--step", "30", "--zone", "America/New_York"});
    for (const char* command : {"scenarios", "impact", "score"})
        expectClean({command, file_, "--region", "Park", "--cell", "20", "--start", "2026-12-21", "--at",
                     "12:00", "--hours", "1", "--step", "30", "--zone", "America/New_York", "--overwrite",
                     "--out", folder_.path("out").string()});
}

TEST_F(StrangeNames, OfACityFileSendNoCommandsToATerminal) {
    expectClean({"info", city_});
    expectClean({"info", city_, "--json"});
    expectClean({"info", city_, "--height-field", "no such field"});
    expectClean({"places", city_});
    expectClean({"import", city_, "--out", folder_.path("city.gpkg").string()});
    expectClean({"info", folder_.path("city.gpkg").string()});
    expectClean({"point", city_, "--at", "0.0015,0.0005", "--zone", "UTC", "--step", "60"});
    expectClean({"study", city_, "--region", "city", "--cell", "5", "--start", "2026-03-21", "--hours", "1",
                 "--zone", "UTC", "--engine", "horizon", "--contributions", "--out",
                 folder_.path("study").string()});
    expectClean({"project", "new", folder_.path("new.noonmark.gpkg").string(), city_});
    expectClean({"info", folder_.file(strange.substr(0, 12) + ".geojson", "{}").string()});
}

}  // namespace

}  // namespace noonmark::cli::tests
