#include "core/engines/api/engine_registry.h"

#include <gmock/gmock.h>

#include <limits>

#include "core/describe/field_values.h"
#include "core/lab/lab_engines.h"
#include "tests/core/engines/terrain_scenes.h"

namespace noonmark::tests {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Engines, EveryKeyMakesAnEngine) {
    ASSERT_FALSE(coreAndLabEngines().empty());
    for (const EngineEntry& engine : coreAndLabEngines())
        EXPECT_TRUE(makeEngine(engine.info.key, {}, coreAndLabEngines())) << engine.info.key;
}

TEST(Engines, ThoseOfTheLabStandBeforeTheAutomaticChoice) {
    const auto keysOf = [](const EngineList& engines) {
        std::vector<std::string_view> keys;
        for (const EngineEntry& engine : engines) keys.push_back(engine.info.key);
        return keys;
    };
    EXPECT_THAT(keysOf(coreEngines()), ElementsAre("ray", "projected", "horizon", "auto"));
    EXPECT_THAT(keysOf(coreAndLabEngines()),
                ElementsAre("ray", "projected", "horizon", "sam", "iam", "ray-graph", "auto"));
}

TEST(Engines, AnUnknownKeyNamesTheKnownOnes) {
    const auto unknown = makeEngine("magic");
    ASSERT_FALSE(unknown);
    EXPECT_THAT(unknown.error().text(), HasSubstr("ray"));
}

TEST(Engines, BothEndsOfEveryRangeAreTakenAndNothingBeyond) {
    for (const EngineEntry& engine : coreAndLabEngines())
        for (const Field& option : engine.info.options) {
            const auto made = [&](double value) {
                return makeEngine(engine.info.key, {{std::string(option.key), value}}, coreAndLabEngines());
            };
            const ValueRange range = option.range.value_or(ValueRange{0, 1});  // yes or no
            EXPECT_TRUE(made(range.min)) << option.key;
            // The available OpenCL devices depend on the machine.
            EXPECT_TRUE(made(range.max) || option.key == "device") << option.key;
            EXPECT_TRUE(made(*asNumber(option.standard))) << option.key;
            for (const double wrong :
                 {range.min - 1, range.max + 1, std::numeric_limits<double>::quiet_NaN()}) {
                const auto refused = made(wrong);
                ASSERT_FALSE(refused) << option.key << ' ' << wrong;
                EXPECT_THAT(refused.error().text(), HasSubstr("Give"));
            }
        }
}

TEST(Engines, ErrorsOfOptionsSayWhatTheyTake) {
    const auto refused = [](std::string_view engine, const EngineSettings& settings) {
        return makeEngine(engine, settings, coreAndLabEngines()).error().text();
    };
    EXPECT_EQ(refused("iam", {{"levels", 2.5}}),
              "levels: Source levels: 2.5 is no whole number. Give 1 to 8");
    EXPECT_EQ(refused("sam", {{"bias", 11}}), "bias: Bias: 11 m is out of range. Give 0 to 10 m");
    EXPECT_EQ(refused("horizon", {{"check", 0.5}}),
              "check: Check runs: 0.5 is neither yes nor no. Give yes or no");
}

TEST(Engines, OptionsReachTheEngine) {
    const City city = cityOf({{{-5, -5, 0}, {5, 5, 20}}});
    const Receivers receivers = receiversOver(city, -20, -20, 20, 20, 4);
    NoProgress progress;
    const auto field = [&](std::string_view engine, const EngineSettings& settings) {
        return makeEngine(engine, settings, coreAndLabEngines())
            .value()
            ->accumulate(city, receivers, oneDay({{150, 40}, {180, 45}}), progress, {})
            .value();
    };
    EXPECT_THAT(field("sam", {{"bias", 0.25}, {"map", 32}}).engine, HasSubstr("bias 0.25 m"));
    EXPECT_THAT(field("sam", {}).engine, HasSubstr("bias 0.001 m"));
    EXPECT_THAT(field("iam", {{"levels", 5}}).engine, HasSubstr("5 levels"));
    EXPECT_TRUE(field("horizon", {}).continuousMin.size() > 0);
}

/// An engine of the tests with one option, which its error states.
struct ToySettings {
    double sharpness = 2;
    bool isLoud = false;
};

TEST(Engines, AnOptionIsOneRow) {
    const Fields<ToySettings> fields{
        field(&ToySettings::sharpness, {.key = "sharpness", .label = "Sharpness", .range = ValueRange{1, 4}}),
        field(&ToySettings::isLoud, {.key = "loud", .label = "Loud"})};
    const EngineList engines{engineOf(
        {"toy", "Toy", "A toy"}, fields, [](const ToySettings& settings) -> Result<std::unique_ptr<Engine>> {
            return failure(settings.isLoud ? "LOUD" : "quiet", std::to_string(int(settings.sharpness)));
        })};
    const auto asked = [&](const EngineSettings& settings) {
        return makeEngine("toy", settings, engines).error().text();
    };
    EXPECT_EQ(asked({}), "2: quiet");
    EXPECT_EQ(asked({{"sharpness", 3}, {"loud", 1}}), "3: LOUD");
    EXPECT_EQ(asked({{"sharpness", 5}}), "sharpness: Sharpness: 5 is out of range. Give 1 to 4");
    EXPECT_THAT(asked({{"sharp", 3}}), HasSubstr("sharpness, loud"));
    ASSERT_EQ(engines[0].info.options.size(), 2U);
    EXPECT_EQ(rangeText(engines[0].info.options[0]), "1 to 4");
    EXPECT_EQ(rangeText(engines[0].info.options[1]), "yes or no");
}

TEST(Engines, AnUnknownOptionNamesTheKnownOnes) {
    const auto refused = makeEngine("iam", {{"level", 2}}, coreAndLabEngines());
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), HasSubstr("levels"));
    EXPECT_THAT(makeEngine("ray", {{"levels", 2}}).error().text(), HasSubstr("Leave it out"));
}

TEST(Engines, AnEngineIsWhatItsEntryStates) {
    for (const EngineEntry& entry : coreAndLabEngines()) {
        const auto engine = makeEngine(entry.info.key, {}, coreAndLabEngines()).value();
        EXPECT_EQ(engine->capabilities().terrain, entry.info.capabilities.terrain) << entry.info.key;
        EXPECT_EQ(engine->capabilities().roofs, entry.info.capabilities.roofs) << entry.info.key;
        EXPECT_EQ(engine->capabilities().sets, entry.info.capabilities.sets) << entry.info.key;
        EXPECT_EQ(engine->capabilities().attribution, entry.info.capabilities.attribution) << entry.info.key;
        EXPECT_EQ(engine->capabilities().choosesEngine, entry.info.capabilities.choosesEngine)
            << entry.info.key;
    }
}

TEST(Engines, ThoseForLevelGroundRefuseTerrainAndTheOthersTakeIt) {
    City city = groundOf(12, [](glm::dvec2 place) { return place.x / 10; });
    city.buildings.push_back(standingBox(city, -5, -5, 5, 5, 20));
    const Receivers receivers = receiversOver(city, -20, -20, 20, 20, 4);
    NoProgress progress;
    for (const EngineEntry& engine : coreAndLabEngines()) {
        const auto field = makeEngine(engine.info.key, {}, coreAndLabEngines())
                               .value()
                               ->accumulate(city, receivers, oneDay({{150, 40}, {180, 45}}), progress, {});
        EXPECT_EQ(bool(field), engine.info.capabilities.terrain) << engine.info.key;
        if (field) continue;
        EXPECT_THAT(field.error().what, HasSubstr("flat ground only"));
        EXPECT_EQ(field.error().kind, ErrorKind::unsupported);
    }
}

TEST(Engines, ThoseWithoutSetsOrAttributionRefuseABreakdownAndTheOthersMakeIt) {
    const City city = cityOf({{{-5, -5, 0}, {5, 5, 20}}});
    const Receivers receivers = receiversOver(city, -20, -20, 20, 20, 4);
    const SunSteps sun = oneDay({{150, 40}, {180, 45}});
    NoProgress progress;
    for (const EngineEntry& entry : coreAndLabEngines())
        for (const bool byBuilding : {false, true}) {
            const auto made =
                makeEngine(entry.info.key, {}, coreAndLabEngines())
                    .value()
                    ->breakDown(city, receivers, sun, makeOneSet(sun), byBuilding, progress, {});
            const EngineCapabilities& able = entry.info.capabilities;
            EXPECT_EQ(bool(made), byBuilding ? able.attribution : able.sets) << entry.info.key;
            if (!made) {
                EXPECT_EQ(made.error().kind, ErrorKind::unsupported) << entry.info.key;
            }
        }
}

}  // namespace
}  // namespace noonmark::tests
