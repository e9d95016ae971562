#include "core/engines/api/engine_registry.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/core/engines/terrain_scenes.h"

namespace noonmark::tests {
namespace {

using ::testing::HasSubstr;

TEST(Engines, EveryKeyMakesAnEngine) {
    ASSERT_FALSE(coreEngines().empty());
    for (const EngineEntry& engine : coreEngines())
        EXPECT_TRUE(makeEngine(engine.info.key)) << engine.info.key;
}

TEST(Engines, AnUnknownKeyNamesTheKnownOnes) {
    const auto unknown = makeEngine("magic");
    ASSERT_FALSE(unknown);
    EXPECT_THAT(unknown.error().text(), HasSubstr("ray"));
}

TEST(Engines, BothEndsOfEveryRangeAreTakenAndNothingBeyond) {
    for (const EngineEntry& engine : coreEngines())
        for (const EngineOption& option : engine.info.options) {
            const auto made = [&](double value) {
                return makeEngine(engine.info.key, {{std::string(option.key), value}});
            };
            EXPECT_TRUE(made(option.min)) << option.key;
            // The available OpenCL devices depend on the machine.
            EXPECT_TRUE(made(option.max) || option.key == "device") << option.key;
            EXPECT_TRUE(made(option.standard)) << option.key;
            for (const double wrong :
                 {option.min - 1, option.max + 1, std::numeric_limits<double>::quiet_NaN()}) {
                const auto refused = made(wrong);
                ASSERT_FALSE(refused) << option.key << ' ' << wrong;
                EXPECT_THAT(refused.error().text(), HasSubstr("Choose"));
            }
        }
}

TEST(Engines, ACountTakesNoFraction) {
    const auto refused = makeEngine("iam", {{"levels", 2.5}});
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), HasSubstr("1 to 8, whole numbers"));
}

TEST(Engines, AnUnknownOptionNamesTheKnownOnes) {
    const auto refused = makeEngine("iam", {{"level", 2}});
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), HasSubstr("levels"));
    EXPECT_THAT(makeEngine("ray", {{"levels", 2}}).error().text(), HasSubstr("Leave it out"));
}

TEST(Engines, AnEngineIsWhatItsEntryStates) {
    for (const EngineEntry& entry : coreEngines()) {
        const auto engine = makeEngine(entry.info.key).value();
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
    for (const EngineEntry& engine : coreEngines()) {
        const auto field = makeEngine(engine.info.key)
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
    for (const EngineEntry& entry : coreEngines())
        for (const bool byBuilding : {false, true}) {
            const auto made =
                makeEngine(entry.info.key)
                    .value()
                    ->breakDown(city, receivers, sun, makeOneSet(sun), byBuilding, progress, {});
            const EngineCapabilities& able = entry.info.capabilities;
            EXPECT_EQ(bool(made), byBuilding ? able.attribution : able.sets) << entry.info.key;
            if (!made) {
                EXPECT_EQ(made.error().kind, ErrorKind::unsupported) << entry.info.key;
            }
        }
}

TEST(Options, AreReadAndWrittenByTheirKind) {
    const EngineOption yesNo{.key = "check", .kind = OptionKind::yesNo}, number{.key = "bin"};
    EXPECT_EQ(formatOptionValue(yesNo, 1), "yes");
    EXPECT_EQ(formatOptionValue(number, 0.5), "0.5");
}

}  // namespace
}  // namespace noonmark::tests
