#include <gtest/gtest.h>

#include <bit>
#include <optional>
#include <string>

#include "core/engines/api/engine_registry.h"
#include "core/lab/lab_engines.h"
#include "core/simd/instruction_set.h"
#include "tests/core/engines/terrain_scenes.h"

namespace noonmark {
namespace {

using namespace tests;

// Restores the set that was in use.
class OnEachSet : public ::testing::Test {
protected:
    ~OnEachSet() override { EXPECT_TRUE(useInstructionSet(before_)); }

    // The result of `compute` on the lowest set, after comparing it with those on the others.
    template <class Compute>
    void expectSameBits(const Compute& compute, std::string_view what) {
        std::optional<decltype(compute())> lowest;
        for (const InstructionSet set : availableInstructionSets()) {
            ASSERT_TRUE(useInstructionSet(set));
            auto result = compute();
            if (!lowest) lowest = result;
            EXPECT_TRUE(result == *lowest) << what << " on " << nameOf(set);
        }
    }

private:
    InstructionSet before_ = instructionSetInUse();
};

using InstructionSets = OnEachSet;

// Bits, so that NaN equals NaN and 0 differs from -0.
std::vector<std::uint32_t> bitsOf(const ShadowField& field) {
    std::vector<std::uint32_t> bits;
    for (const auto* values : {&field.grossMin, &field.continuousMin})
        for (const float value : *values) bits.push_back(std::bit_cast<std::uint32_t>(value));
    return bits;
}

struct Scene {
    std::string_view name;
    City city;
    Receivers receivers;
};

std::vector<Scene> makeScenes() {
    std::vector<Scene> scenes;
    City boxes = cityOf(randomBoxes(3, 6));  // some raised above the ground
    boxes.buildings.push_back(
        buildingOf({rectangle(20, 20, 60, 60), {rectangle(30, 30, 50, 50)}}, 8, 24, true));
    const Receivers ground = receiversOver(boxes, -10, -10, 131, 120);
    scenes.push_back({"boxes", std::move(boxes), ground});
    City hills = groundOf(30, RandomHills(7));
    addStandingBoxes(hills, 5, 6, -60);
    const Receivers uneven = receiversOver(hills, -70, -70, 61, 52);
    scenes.push_back({"hills", std::move(hills), uneven});
    return scenes;
}

TEST_F(InstructionSets, AtLeastOneIsAvailableAndTheLastOneIsUsed) {
    ASSERT_FALSE(availableInstructionSets().empty());
    EXPECT_NE(nameOf(instructionSetInUse()), "not built");
}

TEST_F(InstructionSets, EveryEngineGivesTheSameBits) {
    const SunSteps sun = days(52, 73, 4);
    for (const Scene& scene : makeScenes())
        for (const EngineEntry& entry : coreAndLabEngines()) {
            if (scene.city.terrain && !entry.info.capabilities.terrain) continue;
            const auto engine = makeEngine(entry.info.key, {}, coreAndLabEngines()).value();
            expectSameBits(
                [&] {
                    NoProgress progress;
                    return bitsOf(engine->accumulate(scene.city, scene.receivers, sun, progress, {}).value());
                },
                std::string(entry.info.key) + ", " + std::string(scene.name));
        }
}

}  // namespace
}  // namespace noonmark
