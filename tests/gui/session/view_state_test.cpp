#include "app/gui/session/project/view_state.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

// As versions wrote it whose times were numbers, whose months were yes or no, and whose files of windows
// stated whether heights were above the ground.
TEST(ViewState, OfAnEarlierVersionIsRead) {
    const std::string study =
        R"({"region": {"name": "Lawn", "polygons": [[[[0, 0], [10, 0], [10, 10], [0, 10]]]]}, "cell_m": 2.5,
            "receivers_on": "roofs", "period": {"start": "2026-06-21", "days": 3, "from_min": 450, "hours": 5.0,
            "step_min": 2.0, "zone": "Europe/Paris", "refraction": false,
            "window": {"after_sunrise_min": 30, "before_sunset_min": -15, "rule": 1}}, "pressure_hpa": 990.0,
            "temperature_c": 3.0, "engine": "horizon", "options": {"bin": 0.5}, "by_month": true,
            "contributions": true})";
    const std::string elements =
        R"({"places": "windows", "buildings": ["a"], "bay_m": 4.0, "storey_m": 3.0, "above_floor_m": 1.5,
            "windows": "w.gpkg", "window_id": "nr", "windows_crs": "", "windows_above_ground": true,
            "plane_height_m": 4.0})";
    const ViewState state = parseViewState({{"study", study}, {"elements", elements}});
    ASSERT_TRUE(state.study);
    EXPECT_EQ(state.study->region.name, "Lawn");
    EXPECT_EQ(state.study->region.polygons.size(), 1U);
    EXPECT_EQ(state.study->receivers, (ReceiverSettings{2.5, ReceiverPlaces::roofs}));
    EXPECT_EQ(state.study->period.from, std::chrono::minutes(450));
    EXPECT_EQ(state.study->period.window,
              (SolarHours{std::chrono::minutes(30), std::chrono::minutes(-15), SunriseRule::centre}));
    EXPECT_EQ(state.study->period.days, 3);
    EXPECT_FALSE(state.study->period.refraction);
    EXPECT_EQ(state.study->pressureHPa, 990);
    EXPECT_EQ(state.study->engineSettings, (EngineSettings{{"bin", 0.5}}));
    EXPECT_TRUE(state.study->byMonth);
    EXPECT_TRUE(state.study->contributions);
    ASSERT_TRUE(state.elements);
    EXPECT_EQ(state.elements->places, ElementPlaces::windows);
    EXPECT_TRUE(state.elements->glazingFile.aboveGround);
    EXPECT_EQ(state.elements->glazingFile.crs, std::nullopt);
    EXPECT_EQ(state.elements->glazingFile.idField, "nr");
}

TEST(ViewState, ComesBack) {
    ViewState state;
    state.study.emplace();
    state.study->region = {"Lawn", {{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}}}};
    state.study->period.from = std::chrono::minutes(7 * 60 + 30);
    state.study->period.window = SolarHours{std::chrono::minutes(90), std::chrono::minutes(0)};
    state.study->byMonth = true;
    state.study->temperatureC = -3;
    const ViewState back = parseViewState(textsOf(state));
    ASSERT_TRUE(back.study);
    EXPECT_EQ(back.study->period, state.study->period)
        << "the hours of the clock, too, that do not apply now";
    EXPECT_EQ(*back.study, *state.study);
}

TEST(ViewState, KeepsTheLegend) {
    ViewState state;
    EXPECT_FALSE(textsOf(state).contains("legend")) << "the usual one is not stated";
    state.legend = {
        ShownAs::sun, Ramp::cividis, true, LegendRange{0, 8}, {LegendClasses::Kind::equal, 4, {}}};
    EXPECT_EQ(parseViewState(textsOf(state)).legend, state.legend);
    EXPECT_EQ(parseViewState({{"legend", "{\"ramp\":\"plaid\"}"}}).legend, LegendChoice());
}

TEST(ViewState, OutOfRangeIsNone) {
    ViewState state;
    state.study.emplace();
    state.study->region = {"Lawn", {{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}}}};
    for (const auto& [from, to] : {std::pair{"\"cell_m\":1.0", "\"cell_m\":0.0"},
                                   {"\"temperature_c\":10.0", "\"temperature_c\":900.0"},
                                   {"\"days\":1", "\"days\":0"},
                                   {"\"zone\":\"UTC\"", "\"zone\":\"Nowhere\""}}) {
        auto texts = textsOf(state);
        std::string& study = texts.at("study");
        const auto at = study.find(from);
        ASSERT_NE(at, std::string::npos) << from << " in " << study;
        study.replace(at, std::string(from).size(), to);
        EXPECT_FALSE(parseViewState(texts).study) << to;
    }
}

}  // namespace
}  // namespace noonmark
