// Compares shadow accrual maps with rays on cities, with stated error limits.
#include <gtest/gtest.h>

#include <cmath>

#include "core/engines/ray/surface_rays.h"
#include "core/engines/ray/visible_surface.h"
#include "core/io/read_city.h"
#include "core/lab/accrual/shadow_accrual_map.h"
#include "core/lab/accrual/surface_accrual.h"
#include "core/lab/graph/graph_engine.h"
#include "core/samples/sample_city.h"
#include "tests/core/engines/scenes.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

using namespace tests;

/// Mean difference over receivers in minutes, percent of the time.
struct Failure {
    double gross = 0;
    double continuous = 0;
};

Failure failureOf(const auto& shadow, const auto& truth) {
    Failure failure;
    double count = 0;
    for (std::size_t i = 0; i < truth.grossMin.size(); ++i) {
        if (std::isnan(truth.grossMin[i])) continue;
        failure.gross += std::abs(double(shadow.grossMin[i]) - double(truth.grossMin[i]));
        failure.continuous += std::abs(double(shadow.continuousMin[i]) - double(truth.continuousMin[i]));
        ++count;
    }
    const double percent = 100 / (count * truth.sunlitMinutesPerDay);
    return {failure.gross * percent, failure.continuous * percent};
}

void expectBelow(const Failure& failure, const Failure& stated) {
    EXPECT_LT(failure.gross, stated.gross);
    EXPECT_LT(failure.continuous, stated.continuous);
}

SunSteps hours(const City& city, int from, double count, CivilDate date) {
    return computeSunSteps({.start = date,
                            .from = std::chrono::minutes(from * 60),
                            .hours = count,
                            .zone = "America/New_York"},
                           {.place = city.frame.origin()})
        .value();
}

constexpr CivilDate spring{std::chrono::year{2026}, std::chrono::March, std::chrono::day{21}};
constexpr CivilDate winter{std::chrono::year{2026}, std::chrono::December, std::chrono::day{21}};

class AccrualAgreement : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        if (GetParam() == "sample") {
            city_ = makeGridSample({.buildings = 2000}).value();
            return;
        }
        const auto file = sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
        if (!file) GTEST_SKIP() << "the shared Midtown extract is missing";
        NoProgress progress;
        city_ = readCity({*file}, {}, progress, {}).value().city;
    }

    [[nodiscard]] Receivers middle() const {
        const Box2 box = bounds(city_);
        const glm::vec2 at = (box.low + box.high) * 0.5F;
        return receiversOver(city_, at.x - 150, at.y - 150, at.x + 150, at.y + 150);
    }

    [[nodiscard]] Failure failure(const SunSteps& sun, const AccrualSettings& settings) const {
        const Receivers receivers = middle();
        NoProgress progress;
        const auto field = GraphEngine(ShadowAccrualMap::make(settings).value(), {.merge = false})
                               .accumulate(city_, receivers, sun, progress, {})
                               .value();
        return failureOf(field, traced(city_, receivers, sun));
    }

    City city_;
};

// With texels aligned with cells, the remaining error is due to the straight sun path and is larger for a low
// sun. Stretched over 300 cells, 1024 texels are off by up to a sixth of a cell.
TEST_P(AccrualAgreement, OnTheGround) {
    const SunSteps morning = hours(city_, 9, 2, spring), dusk = hours(city_, 14, 2, winter);
    for (const CasterSide side : {CasterSide::awayFromSun, CasterSide::towardsSun}) {
        expectBelow(failure(morning, {.side = side}), {0.02, 0.02});
        expectBelow(failure(dusk, {.side = side}), {0.15, 0.25});
    }
    expectBelow(failure(morning, {.texelsOnCells = false}), {0.6, 0.8});
}

TEST_P(AccrualAgreement, OnWhatACameraSees) {
    const Box2 box = bounds(city_);
    const glm::dvec3 at(glm::dvec2(box.low + box.high) * 0.5, 0);
    const SurfacePoints points =
        findVisibleSurface(RayScene::over(city_).value(), true,
                           makeCamera(at + glm::dvec3(-500, -300, 350), at, 40, 300, 200))
            .value()
            .points;
    NoProgress progress;
    const SunSteps sun = hours(city_, 9, 2, spring);
    const auto truth = SurfaceRays().accumulate(city_, points, sun, progress, {}).value();
    const auto shadow = SurfaceAccrual::make({}, {.merge = false})
                            .value()
                            ->accumulate(city_, points, sun, progress, {})
                            .value();
    expectBelow(failureOf(shadow, truth), {1.5, 3});
}

INSTANTIATE_TEST_SUITE_P(Cities, AccrualAgreement, testing::Values("sample", "Midtown"),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace noonmark
