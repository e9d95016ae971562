#include <fmt/format.h>

#include "core/sun/period.h"
#include "scenarios/edits/apply_edits.h"
#include "scenarios/edits/placed_building.h"
#include "tests/cli/project_command.h"

namespace noonmark::cli::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// Squares of about 84 x 111 m side by side, with a field for their names.
std::string parcelsFile() {
    std::string features;
    for (int i = 0; i < 3; ++i)
        features += fmt::format(
            R"({}{{"type":"Feature","properties":{{"BLOCKLOT":"10-{}","ZONE":"R"}},"geometry":{{"type":"Polygon",)"
            R"("coordinates":[[[{:.3f},40.765],[{:.3f},40.765],[{:.3f},40.766],[{:.3f},40.766],[{:.3f},40.765]]]}}}})",
            i == 0 ? "" : ",", i + 1, -73.980 + 0.001 * i, -73.979 + 0.001 * i, -73.979 + 0.001 * i,
            -73.980 + 0.001 * i, -73.980 + 0.001 * i);
    return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

class ProjectPlaces : public ProjectCommand {
protected:
    [[nodiscard]] std::vector<std::string> lots() const {
        std::vector<std::string> names;
        const Project project = opened();
        for (std::size_t i = 7; i < project.lots.size(); ++i) names.push_back(project.lots[i].name);
        return names;
    }

    std::string parcels_ = folder_.file("parcels.geojson", parcelsFile()).string();
};

TEST_F(ProjectPlaces, ALotIsABoxAPolygonAFileOrABuildingsOutline) {
    EXPECT_THAT(done("lot add", {"box", "-73.98,40.765,-73.979,40.766"}), HasSubstr("box: 93"));
    done("lot add", {"wkt", "polygon((-73.98 40.765,-73.979 40.765,-73.979 40.766,-73.98 40.765))"});
    done("lot add", {"file", parcels_});
    done("lot add", {"own", "--of", "One57"});
    EXPECT_THAT(lots(), testing::ElementsAre("box", "wkt", "file", "file (2)", "file (3)", "own"));
    const Project project = opened();
    EXPECT_NEAR(area(project.lots[7].outline), 2 * area(project.lots[8].outline), 1);
    EXPECT_TRUE(contains(project.lots.back().outline,
                         findMiddle(*project.city->buildings[findBuilding(*project.city, "One57").value()])));
    done("lot remove", {"file", "file (2)", "own"});
    EXPECT_THAT(lots(), testing::ElementsAre("box", "wkt", "file (3)"));
    EXPECT_EQ(project.lots.size() - 3, opened().lots.size());
}

TEST_F(ProjectPlaces, ALotStatesTheRoadsAlongIt) {
    done("lot add", {"box", "-73.98,40.765,-73.979,40.766"});
    EXPECT_THAT(done("lot set-roads", {"box", "south=8", "east=12.5"}),
                HasSubstr("box: roads south=8, east=12.5"));
    EXPECT_EQ(formatText(opened().lots.back().roads), "south=8, east=12.5");
    EXPECT_THAT(done("lot list", {}), HasSubstr("roads south=8, east=12.5"));
    EXPECT_THAT(refused("lot set-roads", {"box", "up=8"}), HasSubstr("names no side"));
    EXPECT_THAT(refused("lot set-roads", {"nowhere", "south=8"}), HasSubstr("nowhere"));
    EXPECT_THAT(done("lot set-roads", {"box"}), HasSubstr("box: no roads"));
    EXPECT_TRUE(opened().lots.back().roads.empty());
}

TEST_F(ProjectPlaces, LotsComeFromARegisterByTheFieldOfTheirNames) {
    EXPECT_THAT(done("lot import", {parcels_, "--name-field", "blocklot"}), HasSubstr("10-1: 93"));
    EXPECT_THAT(lots(), testing::ElementsAre("10-1", "10-2", "10-3"));
    done("lot import", {parcels_, "--name-field", "BLOCKLOT", "--only", "10-2"});
    done("lot import", {parcels_, "--name-field", "ZONE", "--within", "-73.9785,40.76,-73.97,40.77"});
    done("lot import", {parcels_, "--within", "-73.9785,40.76,-73.97,40.77"});
    EXPECT_THAT(lots(), testing::ElementsAre("10-1", "10-2", "10-3", "10-2 (2)", "R", "lot"));
    done("add-scenario", {"A"});
    EXPECT_THAT(
        done("extrude", {"--scenario", "A", "--lot", "10-3", "--id", "x", "--storeys", "3", "--clear"}),
        HasSubstr("x: 3 storeys"));
}

TEST_F(ProjectPlaces, MistakesOfLotsSayWhatToDo) {
    EXPECT_THAT(refused("lot import", {parcels_, "--name-field", "owner"}), HasSubstr("BLOCKLOT, ZONE"));
    EXPECT_THAT(refused("lot import", {parcels_, "--name-field", "BLOCKLOT", "--only", "9-9"}),
                AllOf(HasSubstr("'9-9'"), HasSubstr("10-1, 10-2")));
    EXPECT_THAT(refused("lot import", {parcels_, "--layer", "roads"}), HasSubstr("Its layers are: parcels"));
    EXPECT_THAT(refused("lot import", {parcels_, "--within", "-73.9,40.76,-73.8,40.77"}),
                HasSubstr("No parcel of the file lies in the region"));
    EXPECT_THAT(refused("lot import", {folder_.path("gone.gpkg").string()}), HasSubstr("gone.gpkg"));
    EXPECT_THAT(refused("lot add", {"One57", "-73.98,40.765,-73.979,40.766"}), HasSubstr("lot remove"));
    EXPECT_THAT(refused("lot add", {"x"}), HasSubstr("place"));
    EXPECT_THAT(refused("lot add", {"x", "POLYGON ((1 2"}), HasSubstr("well-known text"));
    EXPECT_THAT(
        refused("lot add", {"x", "POLYGON ((40.76 -73.98, 40.77 -73.98, 40.77 -73.97, 40.76 -73.98))"}),
        HasSubstr("km from the city"));
    EXPECT_THAT(refused("lot add", {"x", "POLYGON ((-73.98 40.76, -73.98 40.76))"}), HasSubstr("no area"));
    EXPECT_THAT(refused("lot add", {"x", "--of", "nothing"}), HasSubstr("no such building"));
    EXPECT_THAT(refused("lot add", {"", "-73.98,40.765,-73.979,40.766"}), HasSubstr("no name"));
    EXPECT_THAT(refused("lot remove", {"mine"}), HasSubstr("'One57'"));
}

TEST_F(ProjectPlaces, RegionsAndPeriodsAreNamedAndMeasured) {
    done("region add", {"Corner", "-73.98,40.766,-73.978,40.767"});
    EXPECT_THAT(refused("region add", {"Corner", "-73.98,40.766,-73.978,40.767"}), HasSubstr("Corner"));
    EXPECT_THAT(refused("region add", {"Far", "13.3,52.5,13.4,52.6"}), HasSubstr("km from the city"));
    const CommandOutput list = project("region list", {"--json"});
    ASSERT_EQ(list.json().size(), 2U);
    EXPECT_EQ(list.json()[1]["name"], "Corner");
    EXPECT_GT(list.json()[1]["area_m2"].get<double>(), 10000);
    EXPECT_THAT(done("period add", {"noon", "--start", "2026-12-21", "--days", "3", "--at", "12:00",
                                    "--hours", "1", "--step", "10", "--zone", "America/New_York"}),
                HasSubstr("noon: 2026-12-21, 3 days, 12:00 for 1 h"));
    EXPECT_THAT(done("period list", {}), HasSubstr("America/New_York"));
    const CommandOutput named =
        measured("impact", {"--to", "Existing", "--region", "Corner", "--period", "noon", "--json"});
    EXPECT_EQ(named.code, 2);  // two regions
    const CommandOutput score = measured("score", {"--period", "noon", "--json", "--keep", "December"});
    ASSERT_EQ(score.code, 0) << score.err;
    EXPECT_EQ(score.json()["period"]["days"], 3);
    EXPECT_THAT(done("result list", {}), HasSubstr("score of Existing"));
    done("result remove", {"December"});
    EXPECT_TRUE(opened().results.empty());
    EXPECT_THAT(measured("score", {"--period", "noon", "--days", "2"}).err, HasSubstr("--days"));
    EXPECT_THAT(measured("score", {"--period", "midnight"}).err, HasSubstr("'noon'"));
    EXPECT_THAT(measured("score", {}).err, HasSubstr("--period NAME"));
    EXPECT_THAT(refused("period add", {"x", "--start", "2026-02-30", "--zone", "UTC"}),
                HasSubstr("2026-02-30"));
    EXPECT_THAT(refused("period add", {"x"}), HasSubstr("--start"));
    done("period remove", {"noon"});
    done("region remove", {"Corner"});
    EXPECT_THAT(done("period list", {}), HasSubstr("has none"));
    EXPECT_THAT(refused("region remove", {"Corner"}), HasSubstr("'Park'"));
}

TEST_F(ProjectPlaces, WeightTablesGoOutAndIn) {
    const std::string csv = done("weights show", {});
    EXPECT_THAT(csv, HasSubstr("name,first,last,from,to,weight\r\nJanuary,01-01,01-31,00:00,24:00,-1\r\n"));
    done("weights add", {"copy", folder_.file("copy.csv", csv).string()});
    const std::string json = done("weights show", {"--json"});
    done("weights add", {"again", folder_.file("again.json", json).string()});
    const Project project = opened();
    ASSERT_EQ(project.weights.size(), 3U);
    EXPECT_EQ(project.weights[1].intervals, project.weights[0].intervals);
    EXPECT_EQ(project.weights[2].intervals, project.weights[0].intervals);
    done("weights add",
         {"school",
          folder_.file("school.csv", "weight;first;last;from;to\n-1;09-01;06-30;08:00;15:00\n").string()});
    EXPECT_THAT(done("weights list", {}), HasSubstr("school"));
    const CommandOutput score = atNoon("score", {"--weights", "school", "--json"});
    ASSERT_EQ(score.code, 0) << score.err;
    EXPECT_LT(score.json()["score_m2"].get<double>(), 0);
    EXPECT_THAT(refused("weights add",
                        {"bad", folder_.file("bad.csv", "first,last,weight\n13-01,12-31,1\n").string()}),
                AllOf(HasSubstr("bad.csv, line 2, first"), HasSubstr("12-31")));
    EXPECT_THAT(refused("weights add", {"default", folder_.path("copy.csv").string()}), HasSubstr("default"));
    EXPECT_THAT(refused("weights add", {"x", folder_.path("gone.csv").string()}), HasSubstr("gone.csv"));
    done("weights remove", {"copy", "again", "school"});
    EXPECT_EQ(opened().weights.size(), 1U);
}

}  // namespace
}  // namespace noonmark::cli::tests
