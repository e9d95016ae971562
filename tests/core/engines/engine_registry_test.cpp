#include "core/engines/api/engine_registry.h"

#include <gmock/gmock.h>

#include <limits>

#include "core/engines/engine_ground.h"
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
            EXPECT_TRUE(made(option.lowest)) << option.key;
            // The available OpenCL devices depend on the machine.
            EXPECT_TRUE(made(option.highest) || option.key == "device") << option.key;
            EXPECT_TRUE(made(option.usual)) << option.key;
            for (const double wrong :
                 {option.lowest - 1, option.highest + 1, std::numeric_limits<double>::quiet_NaN()}) {
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

TEST(Engines, ThoseThatTakeLevelGroundOnlyAreKnownBeforeTheyRefuseTerrain) {
    City city = groundOf(12, [](glm::dvec2 place) { return place.x / 10; });
    city.buildings.push_back(standingBox(city, -5, -5, 5, 5, 20));
    const Receivers receivers = receiversOver(city, -20, -20, 20, 20, 4);
    NoProgress progress;
    for (const EngineEntry& engine : coreEngines()) {
        const auto field = makeEngine(engine.info.key)
                               .value()
                               ->accumulate(city, receivers, oneDay({{150, 40}, {180, 45}}), progress, {});
        EXPECT_EQ(!field, onLevelGroundOnly(engine.info.key)) << engine.info.key;
        EXPECT_THAT(field ? "flat ground only" : field.error().what, HasSubstr("flat ground only"));
    }
}

}  // namespace
}  // namespace noonmark::tests
