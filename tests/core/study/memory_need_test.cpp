#include "core/study/study_cost.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/lab/lab_engines.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

StudySettings over(float sideM, double cellM) {
    StudySettings settings;
    settings.engine = "ray";
    settings.region = makeRegionFromLocalBox({{0, 0}, {sideM, sideM}});
    settings.receivers.cellM = cellM;
    return settings;
}

TEST(MemoryNeed, GrowsWithTheCells) {
    const double coarse = double(estimateMemory({}, over(10000, 2)));
    const double fine = double(estimateMemory({}, over(10000, 1)));
    EXPECT_NEAR(fine / coarse, 4, 0.01);
    EXPECT_GT(fine, 1e8 * 21);  // size of Receivers and ShadowField for 10^8 cells
}

TEST(MemoryNeed, AnEnginesOwnMemoryCounts) {
    StudySettings settings = over(10000, 1);
    const auto rays = estimateMemory({}, settings);
    settings.engine = "iam";
    EXPECT_GT(estimateMemory({}, settings, coreAndLabEngines()), 3 * rays);
}

TEST(MemoryNeed, CountsTrianglesAndSteps) {
    City city;
    Building building;
    building.parts.push_back({.footprint = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}, .topM = 3});
    city.buildings.assign(1000, std::make_shared<const Building>(building));
    const auto empty = estimateMemory({}, over(100, 1));
    EXPECT_GT(estimateMemory(city, over(100, 1)), empty + std::size_t{1000} * 12 * 100);
    StudySettings year = over(100, 1);
    year.period.days = 365;
    EXPECT_GT(estimateMemory({}, year), empty + std::size_t{364} * 360 * sizeof(SunStep));
}

TEST(MemoryNeed, TooLargeIsRefusedWithItsSize) {
    StudySettings settings = over(10000, 1);
    settings.memoryLimit = 1'000'000'000;
    const auto fits = checkMemory({}, settings);
    ASSERT_FALSE(fits);
    EXPECT_THAT(fits.error().text(), HasSubstr("3.20 GB"));
    EXPECT_THAT(fits.error().text(), HasSubstr("1.00 GB"));
    settings.memoryLimit = 4'000'000'000;
    EXPECT_TRUE(checkMemory({}, settings));
}

TEST(MemoryNeed, AbsurdRegionsDoNotOverflow) {
    StudySettings settings = over(1e15F, 0.25);
    EXPECT_FALSE(checkMemory({}, settings));
}

}  // namespace
}  // namespace noonmark
