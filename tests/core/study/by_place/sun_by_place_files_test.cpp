#include <fmt/format.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/csv_text.h"
#include "core/base/gdal_calls.h"
#include "core/io/places/read_places.h"
#include "core/receivers/place_names.h"
#include "core/study/elements/element_tables.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/core/study/by_place/place_scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;
using testing::Not;

TEST(SunByPlace, PlacesThatChangeStandSideBySideAboveTheirChanges) {
    const std::vector<Place> places{namedPlace("Far", -400, -400, -360, -360),
                                    namedPlace("Park", -30, 20, 50, 60)};
    const SunOfCities all =
        compareByPlace({{"Now", loneTower()}, {"Wall", withSouthWall(loneTower())}, {"Same", loneTower()}},
                       places, settingsOfDays(3));
    const AnswerPage page = makePage(all);
    ASSERT_EQ(page.charts.size(), 4U) << "months and places, each above what changes";
    const Bars &hours = page.charts[2], &changes = page.charts[3];
    EXPECT_EQ(hours.series, (std::vector<std::string>{"Now", "Wall", "Same"}));
    ASSERT_EQ(hours.groups.size(), 1U) << "nothing changes in the far place";
    EXPECT_EQ(groupKey(hours.groups[0]), "Park");
    EXPECT_DOUBLE_EQ(hours.groups[0].values[0], all.baseline.sun[1].meanHours);
    EXPECT_TRUE(changes.isChange);
    EXPECT_NEAR(changes.groups[0].values[0], 60 * all.compared[0].changes[1].meanHours, 1e-9) << "minutes";
    EXPECT_EQ(changes.groups[0].values[1], 0);
    EXPECT_EQ(makePage({all.baseline, {}}).charts.size(), 1U) << "of one city, its months alone";
}

TEST(SunByPlace, PlacesWithoutANameAreNotChartedBesideThoseWithOne) {
    Place unnamed = namedPlace("park (OSM way 7)", -30, 20, 10, 60);
    unnamed.source = "OSM way 7";
    const auto charted = [](const std::vector<Place>& places) {
        std::vector<std::string> names;
        const AnswerPage page = makePage(compareByPlace(
            {{"Now", loneTower()}, {"Wall", withSouthWall(loneTower())}}, places, settingsOfDays(3)));
        for (const Bars::Group& group : page.charts[2].groups) names.push_back(groupKey(group));
        return names;
    };
    EXPECT_EQ(charted({unnamed, namedPlace("Park", 10, 20, 50, 60)}), std::vector<std::string>{"Park"});
    EXPECT_EQ(charted({unnamed}), std::vector<std::string>{"park (OSM way 7)"}) << "rather than nothing";
}

TEST(SunByPlace, OneSentenceJudgesWhichCityTakesLessSun) {
    const SunOfCities all =
        compareByPlace({{"Now", loneTower()}, {"Wall", withSouthWall(loneTower())}, {"Same", loneTower()}},
                       {namedPlace("Park", -30, 20, 50, 60)}, settingsOfDays(3));
    const AnswerPage page = makePage(all);
    ASSERT_GE(page.findings.size(), 2U);
    const std::string verdict = formatText(page.findings[1]);
    EXPECT_THAT(verdict, testing::StartsWith("Same takes less sun than Wall: 0 min against "));
}

TEST(SunByPlace, SentencesCountPlacesOnDatesAndNameTheDarkestAndTheSunniest) {
    const std::vector<Place> places{namedPlace("Far", -400, -400, -360, -360),
                                    namedPlace("Park", -30, 20, 50, 60)};
    SunByPlaceSettings settings = settingsOfDays(3);
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    settings.enoughHours = 0.5;
    const SunByPlace sun = measureByPlace(loneTower(), places, settings);
    std::vector<std::string> findings;
    for (const Sentence& finding : makePage({sun, {}}).findings) findings.push_back(formatText(finding));
    EXPECT_THAT(findings, testing::Contains("On 2026-12-21, 0 of 2 places have less than 0.5 h."));
    EXPECT_THAT(findings,
                testing::Contains(testing::AllOf(testing::StartsWith("Park has the least sun, "),
                                                 testing::HasSubstr(" h a day, and Far the most, "))));
}

TEST(SunByPlace, TheSentencesOfOnePlaceStateItsSunItsDatesAndWhatIsTaken) {
    SunByPlaceSettings settings = settingsOfDays(3);
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    const SunOfCities both = compareByPlace(
        {{"Now", loneTower()}, {"Wall", withSouthWall(loneTower())}},
        {namedPlace("Park", -30, 20, 50, 60), namedPlace("Far", -400, -400, -360, -360)}, settings);
    const AnswerPage page = makePage(both, 0);
    EXPECT_THAT(formatText(page.headline), testing::StartsWith("Park: "));
    ASSERT_EQ(page.findings.size(), 2U);
    EXPECT_THAT(formatText(page.findings[0]), testing::StartsWith("Wall takes "));
    EXPECT_THAT(formatText(page.findings[1]), testing::StartsWith("On 2026-12-21 it has "));
    ASSERT_EQ(page.charts.size(), 2U);
    EXPECT_DOUBLE_EQ(page.charts[0].groups[0].values[0], both.baseline.sun[0].monthHours[0]);
    EXPECT_NE(makePage(both, 1).charts[0].groups[0].values[0], page.charts[0].groups[0].values[0]);
}

// 21 December is a day of the period: of its 9.2 h with the sun up, all but two in shadow are too many.
TEST(SunByPlace, AsShadowSentencesAndChartsStateMinutes) {
    SunByPlaceSettings settings = settingsOfDays(3);
    const CivilDate day = settings.study.period.start;
    settings.dates = {day, std::chrono::year(2020) / 1 / 1};
    const SunOfCities both = compareByPlace(
        {{"Now", loneTower()}, {"Wall", withSouthWall(loneTower())}},
        {namedPlace("Park", -30, 20, 50, 60), namedPlace("Far", -400, -400, -360, -360)}, settings);
    const double possible = possibleHoursOn(both.baseline, [&](const CivilDate& one) { return one == day; });
    ASSERT_GT(possible, 2);
    std::vector<std::string> findings;
    for (const Sentence& finding : makePage(both, ShownAs::shadow).findings)
        findings.push_back(formatText(finding));
    EXPECT_THAT(findings,
                testing::Contains(fmt::format("On {}, 0 of 2 places lie in shadow for more than {:.0f} min.",
                                              formatText(day), (possible - 2) * 60)));
    EXPECT_THAT(findings, testing::Contains("On 2020-01-01, 1 of 2 places have less than 2 h."))
        << "no day of the period: what the sun might have had is not known";
    const AnswerPage page = makePage(both, 0, ShownAs::shadow);
    EXPECT_THAT(formatText(page.headline), testing::HasSubstr("or less"));
    EXPECT_THAT(formatText(page.findings[1]), testing::HasSubstr("it lies in shadow for "));
    ASSERT_EQ(page.charts.size(), 2U);
    const SunOfPlace &before = both.baseline.sun[0], &after = both.compared[0].sun.sun[0];
    EXPECT_NEAR(page.charts[1].groups[0].values[0], (before.monthHours[0] - after.monthHours[0]) * 60, 1e-9)
        << "more shadow is what the sun lost";
}

TEST(SunByPlace, TheForecastIsOfTheCellsAndStepsThatAreMeasured) {
    const std::vector<Place> places{namedPlace("Park", -30, 20, 50, 60)};
    const SunByPlaceSettings settings = settingsOfDays(3);
    const NamedCity alone[]{{{}, loneTower()}};
    const auto forecast = forecastSunByPlace(alone, places, settings, {});
    ASSERT_TRUE(forecast) << forecast.error().text();
    const SunByPlace sun = measureByPlace(loneTower(), places, settings);
    EXPECT_EQ(std::ptrdiff_t(forecast->cells),
              std::ranges::count_if(sun.field.grossMin, [](float minutes) { return !std::isnan(minutes); }));
    EXPECT_EQ(forecast->steps, sun.daylight.steps.size());
    EXPECT_GT(forecast->seconds, 0);
    EXPECT_FALSE(forecast->engine.empty() || forecast->engine == "auto");
    EXPECT_FALSE(forecastSunByPlace(alone, {}, settings, {})) << "there is no place";
}

TEST(SunByPlace, ColumnsNameTheScenarios) {
    const SunOfCities all = compareByPlace(
        {{"Now", loneTower()}, {"Tower B!", withSouthWall(loneTower())}, {"tower b?", loneTower()}},
        {namedPlace("Park", -30, 20, 50, 60)}, settingsOfDays(3));
    const std::string csv = toCsv(makeTable(all.baseline, all.compared));
    EXPECT_THAT(csv, HasSubstr("hours_mean_tower_b,"));
    EXPECT_THAT(csv, HasSubstr("change_hours_tower_b,max_loss_min_tower_b,max_gain_min_tower_b,"
                               "share_lost_tower_b,change_shadow_min_tower_b,change_hours_dec_feb_tower_b,"
                               "change_hours_2026-02_tower_b,hours_mean_tower_b_2,"));
    const auto json = nlohmann::json::parse(toJson(all.baseline, all.compared));
    EXPECT_NEAR(json["places"][0]["scenarios"]["Tower B!"]["change_hours"].get<double>(),
                all.compared[0].changes[0].meanHours, 1e-4);
    EXPECT_EQ(json["scenarios"][1]["name"], "tower b?");
    EXPECT_TRUE(json["definitions"].contains("change_hours"));
}

TEST(SunByPlace, TableJsonAndGeoPackageSayTheSame) {
    SunByPlaceSettings settings = settingsOfDays(20);
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    const SunByPlace sun = measureByPlace(
        loneTower(),
        {namedPlace("Park", -30, 20, 50, 60), namedPlace("A, \"B\"", 0, 20, 20, 60, PlaceKind::plaza)},
        settings);
    const ElementTable table = makeTable(sun);
    const std::string csv = toCsv(table);
    EXPECT_THAT(csv, HasSubstr("name,kind,part_of,area_m2,hours_mean,hours_min,hours_max,share_enough,"
                               "hours_dec_feb,hours_mar_may,hours_2026-02,hours_2026-03,hours_2026-12-21,"
                               "share_below_2026-12-21,shadow_mean_min,shadow_most_min,shadow_least_min,"
                               "shadow_dec_feb_min,shadow_mar_may_min,shadow_2026-02_min,shadow_2026-03_min,"
                               "cell_m,without_figures,remarks,lon_deg,lat_deg,source"))
        << "the shadow of a date beyond the period is not known";
    EXPECT_THAT(csv, HasSubstr("\"A, \"\"B\"\"\",plaza,,800.00,"));
    const auto json = nlohmann::json::parse(toJson(sun));
    EXPECT_NEAR(json["places"][1]["hours_mean"].get<double>(), sun.sun[1].meanHours, 1e-4);
    EXPECT_EQ(json["places"][0]["month_hours"].size(), 2U);
    EXPECT_TRUE(json["error"].is_object());

    const tests::TemporaryFolder folder;
    const auto file = folder.path("places.gpkg");
    ASSERT_TRUE(writePlacesGeoPackage(file, sun.city.frame, sun.places, table, makeStyle(sun)));
    NoProgress quiet;
    const auto read = readPlaces(file, {}, sun.city.frame, quiet, {});
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->places.size(), 2U);
    EXPECT_EQ(read->places[1].name, "A, \"B\"");
    EXPECT_EQ(read->places[1].kind, PlaceKind::plaza);
    EXPECT_NEAR(area(read->places[0]), 3200, 1);
}

// A column of the table in JSON: hours of parts of the period stand in objects of their own there.
std::optional<double> numberOf(const nlohmann::json& place, const std::string& column) {
    if (place.contains(column) && place[column].is_number()) return place[column].get<double>();
    for (const auto& [object, prefix] :
         {std::pair("season_hours", "hours_"), std::pair("month_hours", "hours_"),
          std::pair("date_hours", "hours_"), std::pair("share_below", "share_below_"),
          std::pair("season_shadow_min", "shadow_"), std::pair("month_shadow_min", "shadow_"),
          std::pair("date_shadow_min", "shadow_"), std::pair("season_change_hours", "change_hours_"),
          std::pair("month_change_hours", "change_hours_"), std::pair("date_change_hours", "change_hours_")})
        if (column.starts_with(prefix)) {
            std::string key = column.substr(std::string_view(prefix).size());
            if (std::string_view(object).ends_with("_min") && key.ends_with("_min"))
                key.resize(key.size() - std::string_view("_min").size());
            if (place.contains(object) && place[object].contains(key))
                return place[object][key].get<double>();
        }
    return std::nullopt;
}

// The numbers of all files come from one table: what CSV rounds, the GeoPackage holds, and JSON rounds alike.
TEST(SunByPlace, TheCsvIsTheGeoPackageRoundedAndJsonAgrees) {
    SunByPlaceSettings settings = settingsOfDays(20);
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    const SunByPlace sun = measureByPlace(
        loneTower(), {namedPlace("North", -30, 20, 50, 60), namedPlace("East", 24, -10, 61, 15)}, settings);
    const ElementTable table = makeTable(sun);
    const TemporaryFolder folder;
    const auto file = folder.path("places.gpkg");
    ASSERT_TRUE(writePlacesGeoPackage(file, sun.city.frame, sun.places, table, makeStyle(sun)));
    const GdalCalls calls;
    const GDALDatasetUniquePtr read(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR));
    ASSERT_TRUE(read);
    OGRLayer* places = read->GetLayerByName("places");
    ASSERT_NE(places, nullptr);
    const std::string csv = toCsv(table);
    const auto json = nlohmann::json::parse(toJson(sun));
    std::size_t compared = 0, inJson = 0;
    for (std::size_t row = 0; row < 2; ++row) {
        const OGRFeatureUniquePtr feature(places->GetNextFeature());
        ASSERT_TRUE(feature);
        std::string line;
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            const ElementColumn& column = table.columns[i];
            const int field = feature->GetFieldIndex(column.name.c_str());
            ASSERT_GE(field, 0) << column.name;
            line += i == 0 ? "\n" : ",";
            if (!std::holds_alternative<double>(column.kind)) {
                line += feature->GetFieldAsString(field);
                continue;
            }
            const std::size_t begins = line.size();
            line += fmt::format("{:.{}f}", feature->GetFieldAsDouble(field), column.decimals);
            ++compared;
            if (const auto number = numberOf(json["places"][row], column.name)) {
                EXPECT_EQ(fmt::format("{}", *number), fmt::format("{}", std::stod(line.substr(begins))))
                    << column.name << ": to the last digit";
                ++inJson;
            }
        }
        EXPECT_THAT(csv, HasSubstr(line)) << "a row of the CSV, made from the GeoPackage";
    }
    EXPECT_GT(compared, 20U);
    EXPECT_GE(inJson, 2 * (5U + 2 + 2 + 2 + 3 + 2 + 2))
        << "figures, seasons, months, hours and share of the date; shadow of the figures, seasons, months";
}

// What the sun might have had, less the sun; what a scenario changes, month by month.
TEST(SunByPlace, ShadowAndChangesOfPartsFollowFromTheHours) {
    SunByPlaceSettings settings = settingsOfDays(20);
    settings.dates = {settings.study.period.start};
    const SunOfCities all =
        compareByPlace({{"Now", loneTower()}, {"Wall", withSouthWall(loneTower())}},
                       {namedPlace("North", -30, 20, 50, 60), namedPlace("East", 24, -10, 61, 15)}, settings);
    const auto rows = parseCsvRows(toCsv(makeTable(all.baseline, all.compared)));
    const auto json = nlohmann::json::parse(toJson(all.baseline, all.compared));
    const std::string date = formatText(settings.dates[0]);
    for (std::size_t place = 0; place < 2; ++place) {
        const auto at = [&](const std::string& column) {
            const auto& names = rows[0].fields;
            const auto found = std::ranges::find(names, column);
            EXPECT_NE(found, names.end()) << column;
            return std::stod(rows[place + 1].fields[std::size_t(found - names.begin())]);
        };
        const double possible = all.baseline.possibleHours;
        EXPECT_NEAR(at("shadow_mean_min"), 60 * (possible - at("hours_mean")), 0.01);
        EXPECT_NEAR(at("shadow_most_min"), 60 * (possible - at("hours_min")), 0.01) << "least sun";
        EXPECT_NEAR(at("shadow_mean_min_wall") - at("shadow_mean_min"), at("change_shadow_min_wall"), 0.02);
        EXPECT_NEAR(at("change_shadow_min_wall"), -60 * at("change_hours_wall"), 0.01);
        for (const std::string& part : {std::string("2026-02"), std::string("mar_may"), date}) {
            EXPECT_NEAR(at("hours_" + part + "_wall") - at("hours_" + part),
                        at("change_hours_" + part + "_wall"), 2e-4)
                << part;
            EXPECT_GE(at("shadow_" + part + "_min_wall"), at("shadow_" + part + "_min")) << part;
        }
        const auto& other = json["places"][place]["scenarios"]["Wall"];
        for (const std::string column : {"hours_2026-03", "shadow_2026-03_min", "change_hours_2026-03",
                                         "shadow_mean_min", "change_shadow_min", "hours_dec_feb"})
            EXPECT_EQ(numberOf(other, column), at(column + "_wall")) << column << ": to the last digit";
    }
    // The month's sunlit time and the mean of its days add up.
    const double february =
        possibleHoursOn(all.baseline, [](const CivilDate& day) { return unsigned(day.month()) == 2; });
    EXPECT_NEAR(json["places"][0]["month_shadow_min"]["2026-02"].get<double>() / 60 +
                    json["places"][0]["month_hours"]["2026-02"].get<double>(),
                february, 3e-4);
}

// The same classes in the same colours, as minutes.
TEST(SunByPlace, StylesFollowTheSwitchBetweenSunAndShadow) {
    SunByPlace sun;
    sun.settings.enoughHours = 3;
    sun.possibleHours = 10;
    sun.sun.resize(2);
    sun.sun[0].meanHours = 8.5;
    sun.sun[1].meanHours = 1;
    const PlaceColours asSun{{.show = ShownAs::sun}, {}}, asShadow{{.show = ShownAs::shadow}, {}};
    EXPECT_THAT(makeStyle(sun, asSun).qml, HasSubstr(R"(attr="hours_mean")"));
    const LayerStyle style = makeStyle(sun, asShadow);
    EXPECT_EQ(style.name, "Minutes of shadow a day");
    EXPECT_THAT(style.qml, HasSubstr(R"(attr="shadow_mean_min")"));
    const ColourScale hours = makeScale(sun, asSun), minutes = makeScale(sun, asShadow);
    EXPECT_EQ(minutes.unit(), "min");
    EXPECT_THAT(minutes.breaks, testing::Contains(420)) << "3 of 10 hours in the sun: 7 in shadow";
    for (const double of : {0.5, 1.5, 2.5, 3.5, 5.5, 8.5})
        EXPECT_EQ(minutes.colourOf(60 * (10 - of)), hours.colourOf(of)) << of;
    sun.possibleHours = SunOfPlace::none;
    EXPECT_THAT(makeStyle(sun, asShadow).qml, HasSubstr(R"(attr="hours_mean")"))
        << "what the sun might have had is not known";
}

TEST(SunByPlace, StyleHasTheClassesAroundEnoughSunInTheColoursOfTheLegend) {
    SunByPlace sun;
    sun.settings.enoughHours = 3;
    sun.sun.resize(2);
    sun.sun[0].meanHours = 8.5;
    const std::string qml = makeStyle(sun).qml;
    EXPECT_THAT(qml, HasSubstr(R"(attr="hours_mean")"));
    EXPECT_THAT(qml, HasSubstr(R"(lower="2" upper="3" symbol="2")"));
    EXPECT_THAT(qml, HasSubstr(R"(lower="3" upper="5" symbol="3" label="3 to 5 h")"));
    EXPECT_THAT(qml, HasSubstr(R"(<symbol type="fill" name="5")"));
    EXPECT_THAT(makeStyle(sun, {{}, 6.0}).qml, HasSubstr(R"(lower="6" upper=")"));
    EXPECT_NE(makeStyle(sun, {{.ramp = Ramp::viridis}, {}}).qml, qml);
}

TEST(SunByPlace, OtherStylesColourByTheHoursOfDatesSeasonsAndMonths) {
    SunByPlaceSettings settings = settingsOfDays(20);
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    const SunByPlace sun = measureByPlace(loneTower(), {namedPlace("Park", -30, 20, 50, 60)}, settings);
    const std::vector<LayerStyle> others = makeStyle(sun).others;
    std::vector<std::string> columns;
    for (const ElementColumn& column : makeTable(sun).columns) columns.push_back(column.name);
    ASSERT_EQ(others.size(), 1U + 2 + 2) << "winter and spring, February and March";
    for (const LayerStyle& one : others) {
        const std::size_t first = one.qml.find("attr=\"") + 6, end = one.qml.find('"', first);
        EXPECT_THAT(columns, testing::Contains(one.qml.substr(first, end - first))) << one.name;
    }
    EXPECT_EQ(others.front().name, "Hours of sun a day, 2026-12-21");
}

TEST(SunByPlace, TheCommandNamesPlacesScenariosAndSettings) {
    SunByPlace sun;
    EXPECT_FALSE(makeRepeatCommand(sun));
    sun.name = "Existing";
    sun.asked = PlaceSelection{{{"--kind", {"park"}}}, true};
    sun.settings = settingsOfDays(3);
    sun.settings.enoughHours = 3;
    sun.settings.dates = {std::chrono::year(2026) / 12 / 21};
    sun.provenance.project = ProjectRecord{"town.noonmark.gpkg", "hash", {}, {}, {}};
    std::vector<ComparedSun> compared(1);
    compared[0].sun.name = "Lower tower";
    const auto command = makeRepeatCommand(sun, compared, 1000);
    ASSERT_TRUE(command) << command.error().text();
    EXPECT_THAT(*command, HasSubstr("noonmark-cli by-place town.noonmark.gpkg "));
    EXPECT_THAT(*command, HasSubstr("--baseline Existing --scenario 'Lower tower' --kind park"));
    EXPECT_THAT(*command, HasSubstr("--enough 3 --date 2026-12-21"));
    EXPECT_THAT(*command, Not(HasSubstr("--region")));
    EXPECT_THAT(*command, Not(HasSubstr("--by month")));
}

}  // namespace
}  // namespace noonmark
