#include "app/gui/tools/live/live_effects.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/gui/live_scene.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using namespace test;

FacadeQuestion questionOf(const FacadeQuestion::Buildings& shape,
                          const FacadeQuestion::Buildings& neighbours = {}) {
    const SunQuestion sun = sunOf(spring(1, 1));
    return {
        .rest = std::make_shared<const City>(smallCity()),
        .sun = std::make_shared<const SunSteps>(computeDaylightSteps(sun.period, sun.observer, {}).value()),
        .shape = shape,
        .neighbours = neighbours};
}

// The tower has 4 walls of 10 bays and 34 storeys; South House touches 3 bays of 17 storeys.
TEST(FacadeSunlight, IsThatOfAStudyOfTheTowersFacades) {
    NoProgress quiet;
    const FacadeAnswer answer = measureFacades(questionOf(tower()), quiet, {}).value();
    ASSERT_EQ(answer.map.elements.size(), 1309U);
    City city = with(smallCity(), tower());
    ElementSettings elements{.buildings = {"Tower 1"}};
    StudySettings settings;
    settings.region = makeRegionFromLocalBox({{-500, -500}, {500, 500}});
    settings.period = spring(1, 1);
    const ElementStudy study = runElementStudy(city, settings, elements, quiet, {}).value();
    const ElementMap map = makeElementMap(study);
    ASSERT_EQ(map.elements.size(), 1309U);
    for (std::size_t i = 0; i < 1309; i += 37) {
        EXPECT_EQ(answer.map.elements[i].id, map.elements[i].id);
        EXPECT_NEAR(answer.map.elements[i].sunlitMin, map.elements[i].sunlitMin, 2);
    }
}

// Of 4 m each: 30 storeys, and 15 that South House touches.
TEST(FacadeSunlight, IsOnTheTowersOwnStoreys) {
    NoProgress quiet;
    FacadeQuestion question = questionOf(tower());
    question.storeys = {{tower().front()->sourceId, 4}};
    EXPECT_EQ(measureFacades(question, quiet, {}).value().map.elements.size(), 4U * 10 * 30 - 3 * 15);
}

TEST(FacadeSunlight, IsCoarseWhileTheTowerMoves) {
    NoProgress quiet;
    const FacadeAnswer coarse = measureFacadesCoarsely(questionOf(tower()), 100, quiet, {}).value();
    EXPECT_TRUE(coarse.coarse);
    EXPECT_GT(coarse.map.elements.size(), 50U);
    EXPECT_LT(coarse.map.elements.size(), 200U);
    double area = 0;
    for (const MeasuredElement& element : coarse.map.elements)
        area += (element.pane.high.x - element.pane.low.x) * (element.pane.high.y - element.pane.low.y);
    EXPECT_NEAR(area, 4 * 30 * 120, 0.25 * 4 * 30 * 120) << "the tiles cover the walls";
}

TEST(FacadeSunlight, IsMeasuredOnChosenNeighboursToo) {
    NoProgress quiet;
    FacadeQuestion question = questionOf(tower());
    question.neighbours = {question.rest->buildings[1]};
    const FacadeAnswer answer = measureFacades(question, quiet, {}).value();
    std::set<std::string> buildings;
    for (const MeasuredElement& element : answer.map.elements) buildings.insert(element.building);
    EXPECT_EQ(buildings, (std::set<std::string>{"Low House", "Tower 1"}));
}

struct LiveFacadesTest : ::testing::Test {
    LiveFacades facades;
    std::vector<std::shared_ptr<const FacadeAnswer>> answers;

    void SetUp() override {
        QObject::connect(&facades, &LiveFacades::changed, &facades,
                         [this] { answers.push_back(facades.answer()); });
        facades.begin(smallCity(), sunOf(spring(1, 1)), {});
    }
    bool rests() {
        return waitFor([this] { return !answers.empty() && !answers.back()->coarse; });
    }
};

TEST_F(LiveFacadesTest, EndAtEveryBayOfTheNewestShape) {
    for (int step = 0; step < 12; ++step) {
        facades.follow(tower(float(step)), {});
        QCoreApplication::processEvents();
    }
    ASSERT_TRUE(rests());
    EXPECT_TRUE(answers.front()->coarse);
    EXPECT_LE(answers.size(), 13U) << "shapes that were overtaken are not measured";
    float west = 1e9F;
    for (const MeasuredElement& element : answers.back()->map.elements)
        west = std::min(west, element.position.x);
    EXPECT_NEAR(west, 31, 0.1);
    EXPECT_EQ(answers.back()->map.elements.size(), 40U * 34) << "bays of 120 m of height in storeys of 3.5 m";
}

TEST_F(LiveFacadesTest, MeasureNothingAfterTheirEnd) {
    facades.follow(tower(), {});
    facades.end();
    facades.follow(tower(), {});
    EXPECT_FALSE(facades.working().busy());
    EXPECT_FALSE(facades.answer());
}

}  // namespace
}  // namespace noonmark
