#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "app/report/files/read_report.h"
#include "core/base/csv_text.h"
#include "core/io/heights/height_facts.h"
#include "tests/cli/project_command.h"
#include "tests/shared/shared_data.h"

namespace noonmark::cli::tests {
namespace {

using noonmark::tests::readBytes;
using noonmark::tests::sharedData;
using testing::AllOf;
using testing::HasSubstr;

// Squares of about 84 x 111 m in the park, side by side.
std::string parksFile() {
    std::string features;
    for (int i = 0; i < 2; ++i)
        features += fmt::format(
            R"({}{{"type":"Feature","properties":{{"name":"{}","kind":"{}"}},"geometry":{{"type":"Polygon",)"
            R"("coordinates":[[[{:.3f},40.766],[{:.3f},40.766],[{:.3f},40.767],[{:.3f},40.767],[{:.3f},40.766]]]}}}})",
            i == 0 ? "" : ",", i == 0 ? "Pond Lawn" : "Heckscher", i == 0 ? "park" : "playground",
            -73.977 + 0.001 * i, -73.976 + 0.001 * i, -73.976 + 0.001 * i, -73.977 + 0.001 * i,
            -73.977 + 0.001 * i);
    return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

class PlacesCommand : public ProjectCommand {
protected:
    void SetUp() override {
        ProjectCommand::SetUp();
        EXPECT_THAT(done("place read", {parks_}), HasSubstr("2 places read"));
        done("add-scenario", {"Without One57"});
        done("demolish", {"One57", "--scenario", "Without One57"});
    }
    std::string parks_ = folder_.file("parks.geojson", parksFile()).string();
};

TEST_F(PlacesCommand, OfAProjectAreReadDrawnListedAndRemoved) {
    EXPECT_THAT(done("place read", {parks_}), HasSubstr("earlier ones replaced: 2"));
    EXPECT_THAT(done("place add", {"Yard", "-73.98,40.765,-73.979,40.766", "--as", "schoolyard"}),
                HasSubstr("Yard: schoolyard"));
    EXPECT_THAT(refused("place add", {"Yard", "-73.98,40.765,-73.979,40.766"}), HasSubstr("place remove"));
    EXPECT_THAT(refused("place add", {"x", "1,2,3", "--as", "park"}), HasSubstr("x"));
    const auto listed = noonmarkCli({"places", file_, "--json"}).json();
    ASSERT_EQ(listed["places"].size(), 3U);
    EXPECT_EQ(listed["places"][1]["name"], "Heckscher");
    EXPECT_EQ(listed["places"][1]["kind"], "playground");
    EXPECT_NEAR(listed["places"][1]["area_m2"].get<double>(), 9370, 30);
    EXPECT_EQ(noonmarkCli({"places", file_, "--kind", "schoolyard", "--json"}).json()["places"].size(), 1U);
    EXPECT_THAT(noonmarkCli({"places", file_, "--kind", "lawn"}).err, HasSubstr("not a kind of place"));
    done("place remove", {"pond lawn"});
    EXPECT_EQ(opened().places.size(), 2U);
    EXPECT_EQ(noonmarkCli({"places", file_, "--from", parks_, "--json"}).json()["places"].size(), 4U);
}

TEST_F(PlacesCommand, TheTimelineOfADayHasTheKeysThatScriptsRelyOn) {
    // One57's shadow passes over the lawn, which is 67 deg from it, in the late afternoon. In December the
    // sun sets at 238 deg, too far south for that.
    const auto output =
        noonmarkCli({"timeline", file_, "--place", "pond lawn", "--day", "2026-03-21", "--from",
                     "Without One57", "--to", "Existing", "--step", "10", "--json"});
    ASSERT_EQ(output.code, 0) << output.err;
    const auto json = output.json();
    EXPECT_EQ(json["place"], "Pond Lawn");
    EXPECT_EQ(json["from"], "Without One57");
    ASSERT_GT(json["steps"].size(), 40U);
    double maximum = 0, hours = 0;
    for (const auto& step : json["steps"]) {
        EXPECT_THAT(step["at"].get<std::string>(), HasSubstr("2026-03-21T"));
        const double baseline = step["baseline_m2"], scenario = step["scenario_m2"],
                     incremental = step["incremental_m2"];
        EXPECT_NEAR(baseline + incremental, scenario, 2e-4);  // One57 is only added; areas are rounded
        maximum = std::max(maximum, incremental);
        hours += incremental * json["step_min"].get<double>() / 60;
    }
    EXPECT_EQ(json["incremental"]["largest_m2"], maximum);
    EXPECT_NEAR(json["incremental"]["area_hours_m2h"].get<double>(), hours, 0.1);  // areas are rounded
    EXPECT_GT(maximum, 0);
}

TEST_F(PlacesCommand, TimelinesAreStatedInWordsAndAsCsv) {
    const std::vector<std::string> asked{
        "timeline", file_,   "--place", "all", "--day",  "2026-12-21", "--to",   "Without One57",
        "--at",     "11:00", "--hours", "1",   "--step", "20",         "--zone", "America/New_York"};
    const auto words = noonmarkCli(asked);
    EXPECT_THAT(words.out, AllOf(HasSubstr("Pond Lawn (park)"), HasSubstr("Heckscher (playground)"),
                                 HasSubstr("60 min of sun")));
    auto csv = asked;
    csv.emplace_back("--csv");
    const std::string rows = noonmarkCli(csv).out;
    EXPECT_EQ(std::ranges::count(rows, '\n'), 1 + 2 * 3);
    EXPECT_THAT(rows, HasSubstr("Pond Lawn,2026-12-21,2026-12-21T11:20:00-05:00,"));
    EXPECT_THAT(noonmarkCli({"timeline", file_, "--place", "Pond Lane", "--day", "2026-12-21"}).err,
                HasSubstr("Did you mean Pond Lawn?"));
    EXPECT_EQ(noonmarkCli({"timeline", file_, "--place", "all"}).code, 2);
}

TEST_F(PlacesCommand, SeveralDaysHaveSumsByMonthAndQuarter) {
    const auto json = noonmarkCli({"timeline", file_, "--place", "Pond Lawn", "--day", "2026-12-20", "--days",
                                   "3", "--to", "Without One57", "--step", "60", "--json"})
                          .json();
    EXPECT_EQ(json["days"].size(), 3U);
    EXPECT_EQ(json["sums"]["days"], 3);
    EXPECT_EQ(json["months"]["2026-12"]["days"], 3);
    EXPECT_EQ(json["quarters"]["21 Dec to 20 Mar"]["days"], 2);
    EXPECT_FALSE(json.contains("steps"));
}

TEST_F(PlacesCommand, ScreeningNamesTheReasons) {
    done("place add", {"Far", "-73.99,40.80,-73.989,40.801"});
    done("place add", {"South", "-73.98,40.76,-73.979,40.761"});
    const auto json = noonmarkCli({"screen", file_, "--from", "Without One57", "--to", "Existing", "--step",
                                   "15", "--json"})
                          .json();
    std::map<std::string, std::string> results;
    for (const auto& place : json["places"]) results[place["name"]] = place["result"];
    EXPECT_EQ(results["Pond Lawn"], "reached");
    EXPECT_EQ(results["Far"], "beyond the longest shadow");
    EXPECT_EQ(results["South"], "in the no-shadow sector");
    EXPECT_THAT(noonmarkCli({"screen", file_, "--to", "Without One57"}).err, HasSubstr("adds no building"));
    EXPECT_THAT(noonmarkCli({"screen", file_, "--to", "Existing", "--no-shadow", "x..y"}).err,
                HasSubstr("108..252"));
}

TEST_F(PlacesCommand, ARegionMayBeAPlaceByItsName) {
    const auto study =
        noonmarkCli({"study", file_, "--region", "pond lawn", "--start", "2026-12-21", "--from", "12:00",
                     "--hours", "1", "--step", "30", "--zone", "America/New_York", "--cell", "4", "--out",
                     folder_.path("out").string(), "--json"});
    ASSERT_EQ(study.code, 0) << study.err;
    EXPECT_THAT(noonmarkCli({"study", file_, "--region", "Pond Lane", "--start", "2026-12-21", "--from",
                             "12:00", "--zone", "America/New_York", "--out", folder_.path("other").string()})
                    .err,
                HasSubstr("Pond Lawn"));
}

// One57 shades the lawn: without it there is more sun, and nothing else changes.
TEST_F(PlacesCommand, SunByPlaceSetsScenariosAgainstTheBaseline) {
    const std::vector<std::string> asked{"by-place",   file_,
                                         "--start",    "2026-03-21",
                                         "--from",     "12:00",
                                         "--hours",    "7",
                                         "--step",     "10",
                                         "--zone",     "America/New_York",
                                         "--cell",     "4",
                                         "--scenario", "Without One57",
                                         "--out",      folder_.path("sun").string(),
                                         "--date",     "2026-03-21"};
    const auto words = noonmarkCli(asked);
    ASSERT_EQ(words.code, 0) << words.err;
    EXPECT_THAT(words.out,
                AllOf(HasSubstr("baseline"), HasSubstr("Without One57: +"), HasSubstr("places.csv")));
    auto again = asked;
    again.insert(again.end(), {"--json", "--overwrite"});
    const auto json = noonmarkCli(again).json();
    const auto& lawn = json["places"][0];
    const auto& without = lawn["scenarios"]["Without One57"];
    EXPECT_GT(without["change_hours"].get<double>(), 0);
    EXPECT_NEAR(without["hours_mean"].get<double>() - lawn["hours_mean"].get<double>(),
                without["change_hours"].get<double>(), 2e-4);
    EXPECT_EQ(without["max_loss_min"], 0);
    EXPECT_EQ(json["baseline"], "Existing");
    again.back() = "--baseline";
    again.insert(again.end(), {"Without One57", "--overwrite"});
    EXPECT_EQ(noonmarkCli(again).json()["places"][0]["scenarios"]["Without One57"]["change_hours"], 0);
    const std::filesystem::path out = folder_.path("sun");
    EXPECT_TRUE(std::filesystem::exists(out / "sun_by_place_2026-03-21.png"));
    EXPECT_THAT(readBytes(out / "sun_by_place_2026-03-21.qml"), HasSubstr("band=\"2\""))
        << "the raster's bands are the period, then the dates";
    EXPECT_THAT(readBytes(out / "sun_by_place.qml"), HasSubstr("band=\"1\""));
}

TEST_F(PlacesCommand, SunByPlaceStatesItsAnswerAndWritesSheets) {
    const auto sun =
        noonmarkCli({"by-place", file_, "--start", "2026-12-21", "--zone", "America/New_York", "--step", "60",
                     "--cell", "4", "--kind", "park", "--region", "-73.980,40.765,-73.978,40.766", "--sheets",
                     "--sheet-date", "May 2026", "--out", folder_.path("sheets").string()});
    ASSERT_EQ(sun.code, 0) << sun.err;
    EXPECT_THAT(sun.out, AllOf(HasSubstr("of 2 places have less than 2 h of sun a day."),
                               HasSubstr("sheets.pdf"), HasSubstr(" expected")));
    EXPECT_THAT(sun.err, HasSubstr("Sun of 2 places: about"));
    EXPECT_TRUE(std::filesystem::exists(folder_.path("sheets") / "sheets.pdf"));
    EXPECT_THAT(noonmarkCli({"by-place", file_, "--start", "2026-12-21", "--zone", "America/New_York",
                             "--region", "Nowhere", "--out", folder_.path("none").string()})
                    .err,
                HasSubstr("Nowhere"));
}

std::string joinWords(const std::string& text) {
    std::istringstream words(text);
    std::string joined;
    for (std::string word; words >> word;) joined += word + ' ';
    return joined;
}

// What is printed of a place, worked out from its rows of places.csv. Those of the scenario are under
// "hours_mean_without_one57".
struct PrintedPlace {
    std::map<std::string, std::string> row;
    [[nodiscard]] double at(const std::string& column) const { return std::stod(row.at(column)); }
    [[nodiscard]] std::string areaText() const {
        return formatThousands(std::size_t(std::lround(at("area_m2"))));
    }
    [[nodiscard]] std::string onTerminal() const {
        return fmt::format(
            "{} {} {:.2f} h of sun a day ({:.2f} to {:.2f}), {:.1f} % with enough Without One57: ",
            row.at("name"), row.at("kind"), at("hours_mean"), at("hours_min"), at("hours_max"),
            100 * at("share_enough"));
    }
    [[nodiscard]] std::string onSheets() const {
        const double gainMin = 60 * at("change_hours_without_one57");
        return fmt::format("{} {} {} {:.2f} {:.2f} {:.2f} {:.0f} % {}{:.1f} ", row.at("name"), row.at("kind"),
                           areaText(), at("hours_mean_without_one57"), at("hours_min_without_one57"),
                           at("hours_max_without_one57"), 100 * at("share_enough_without_one57"),
                           gainMin > 0.05 ? "+" : "", gainMin);
    }
    [[nodiscard]] std::string onSheetsAsShadow() const {
        const double lossMin = at("change_shadow_min_without_one57");
        return fmt::format("{} {} {} {:.0f} {:.0f} {:.0f} {:.0f} % {}{:.1f} ", row.at("name"), row.at("kind"),
                           areaText(), at("shadow_mean_min_without_one57"),
                           at("shadow_most_min_without_one57"), at("shadow_least_min_without_one57"),
                           100 * at("share_enough_without_one57"), lossMin > 0.05 ? "+" : "", lossMin);
    }
};

std::vector<PrintedPlace> readPlacesCsv(const std::filesystem::path& file) {
    const auto rows = parseCsvRows(readBytes(file));
    std::vector<PrintedPlace> places;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const bool isScenario = std::ranges::find(rows[i].fields, "Without One57") != rows[i].fields.end();
        if (!isScenario) places.emplace_back();
        for (std::size_t column = 0; column < rows[0].fields.size(); ++column)
            places.back().row[rows[0].fields[column] + (isScenario ? "_without_one57" : "")] =
                rows[i].fields[column];
    }
    return places;
}

// One measurement: table, JSON, terminal and sheets, as sun and as shadow.
TEST_F(PlacesCommand, SunByPlaceSaysTheSameEverywhere) {
    const auto run = [&](const std::string& out, const std::vector<std::string>& more) {
        std::vector<std::string> asked{"by-place",
                                       file_,
                                       "--start",
                                       "2026-03-21",
                                       "--from",
                                       "12:00",
                                       "--hours",
                                       "7",
                                       "--step",
                                       "10",
                                       "--zone",
                                       "America/New_York",
                                       "--cell",
                                       "4",
                                       "--scenario",
                                       "Without One57",
                                       "--sheets",
                                       "--out",
                                       folder_.path(out).string()};
        asked.insert(asked.end(), more.begin(), more.end());
        CommandOutput output = noonmarkCli(asked);
        EXPECT_EQ(output.code, 0) << output.err;
        return joinWords(output.out);
    };
    const std::string terminal = run("sun", {});
    run("shadow", {"--show", "shadow"});
    const auto places = readPlacesCsv(folder_.path("sun/places.csv"));
    ASSERT_EQ(places.size(), 2U);
    for (const char* table : {"places.csv", "places_by_time.csv"})
        EXPECT_EQ(readBytes(folder_.path("sun") / table), readBytes(folder_.path("shadow") / table))
            << "tables for programs hold both";
    const auto json = nlohmann::json::parse(readBytes(folder_.path("sun/places.json")));
    const auto sun = readPrintedWords(folder_.path("sun/sheets.pdf")),
               shadow = readPrintedWords(folder_.path("shadow/sheets.pdf"));
    ASSERT_TRUE(sun && shadow);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const PrintedPlace& place = places[i];
        EXPECT_THAT(terminal, HasSubstr(place.onTerminal()));
        EXPECT_THAT(joinWords(*sun), HasSubstr(place.onSheets()));
        EXPECT_THAT(joinWords(*shadow), HasSubstr(place.onSheetsAsShadow()));
        for (const char* key : {"area_m2", "hours_mean", "share_enough", "shadow_mean_min"}) {
            EXPECT_EQ(json["places"][i][key].get<double>(), place.at(key)) << key;
            if (std::string(key) == "area_m2") continue;  // the same in all scenarios
            EXPECT_EQ(json["places"][i]["scenarios"]["Without One57"][key].get<double>(),
                      place.at(std::string(key) + "_without_one57"))
                << key;
        }
    }
    EXPECT_THAT(joinWords(*sun), AllOf(HasSubstr("Hours of sun by place"), HasSubstr("Mean sun, h")));
    EXPECT_THAT(joinWords(*shadow),
                AllOf(HasSubstr("Minutes of shadow by place"), HasSubstr("Mean shadow, min")));
    EXPECT_THAT(readBytes(folder_.path("shadow/places.gpkg")), HasSubstr("attr=\"shadow_mean_min\""));
    EXPECT_THAT(json["repeat"].get<std::string>(), testing::Not(HasSubstr("--show")));
    EXPECT_THAT(
        nlohmann::json::parse(readBytes(folder_.path("shadow/places.json")))["repeat"].get<std::string>(),
        HasSubstr("--show shadow"));
}

TEST(PlacesOfFiles, MidtownsParksAndARegionByName) {
    const auto file = sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
    if (!file) GTEST_SKIP() << "the shared Midtown extract is missing";
    const auto listed = noonmarkCli({"places", file->string(), "--named", "--kind", "park", "--json"});
    ASSERT_EQ(listed.code, 0) << listed.err;
    EXPECT_THAT(listed.out, HasSubstr("Bryant Park"));
    noonmark::tests::TemporaryFolder folder;
    EXPECT_THAT(
        noonmarkCli({"study", file->string(), "--region", "Briant Park", "--start", "2026-03-21", "--from",
                     "12:00", "--zone", "America/New_York", "--out", folder.path("out").string()})
            .err,
        HasSubstr("Bryant Park"));
}

}  // namespace
}  // namespace noonmark::cli::tests
