#include <gmock/gmock.h>

#include "core/engines/api/shadow_field.h"
#include "scenarios/impact/impact.h"
#include "scenarios/weights/score.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

using ::testing::HasSubstr;

/// An engine for which half of every receiver's time is dark. It can nothing but that.
class HalfDark final : public Engine {
public:
    [[nodiscard]] std::string_view name() const override { return "Half dark"; }
    [[nodiscard]] EngineCapabilities capabilities() const override { return able; }
    static constexpr EngineCapabilities able{.independence = Independence::always};

protected:
    Result<ShadowField> compute(const City&, const Receivers& receivers, const SunSteps& sun, Progress&,
                                std::stop_token) const override {
        ShadowField field = makeBlankField(receivers, sun);
        field.engine = "Half dark";
        for (const std::uint32_t cell : receivers.cells)
            field.grossMin[cell] = float(field.sunlitMinutesPerDay / 2);
        return field;
    }
};

/// The registry with one line more.
EngineList withHalfDark() {
    EngineList engines = coreEngines();
    engines.push_back({{"half", "Half dark", "Half of the time is dark", HalfDark::able},
                       [](const EngineSettings&) -> Result<std::unique_ptr<Engine>> {
                           return std::make_unique<HalfDark>();
                       }});
    return engines;
}

StudySettings byHalfDark() {
    using namespace std::chrono;
    StudySettings settings;
    settings.region = makeRegionFromLocalBox({{-20, -20}, {90, 30}});
    settings.receivers.cellM = 2;
    settings.period = {.start = 2026y / June / 21, .days = 1, .zone = "America/New_York"};
    settings.engine = "half";
    settings.errorSample.receivers = 0;
    return settings;
}

TEST(ToyEngine, OneLineInTheListGivesStudiesComparisonsAndScores) {
    const EngineList engines = withHalfDark();
    const StudySettings settings = byHalfDark();
    NoProgress progress;
    const auto study = runStudy(threeHouses(), settings, progress, {}, engines);
    ASSERT_TRUE(study) << study.error().text();
    EXPECT_EQ(study->field.engineKey, "half");
    EXPECT_NEAR(study->statistics.shadowAreaM2,
                double(study->receivers.cells.size()) * study->field.grid.cellAreaM2() / 2, 0.5);
    const auto impact = runImpact(threeHouses(), threeHouses(), {.study = settings, .byBuilding = true},
                                  progress, {}, engines);
    ASSERT_TRUE(impact) << impact.error().text();
    EXPECT_EQ(impact->after.engineKey, "half");
    const auto score = runScore(threeHouses(), settings, makeMonthlyWeights(), progress, {}, engines);
    ASSERT_TRUE(score) << score.error().text();
    EXPECT_EQ(score->engineKey, "half");
}

TEST(ToyEngine, WhatItCannotDoIsRefusedWithTheEnginesThatCan) {
    StudySettings settings = byHalfDark();
    settings.byMonth = true;
    NoProgress progress;
    const auto study = runStudy(threeHouses(), settings, progress, {}, withHalfDark());
    ASSERT_FALSE(study);
    EXPECT_EQ(study.error().kind, ErrorKind::unsupported);
    EXPECT_THAT(study.error().advice, HasSubstr("horizon"));
}

}  // namespace
}  // namespace noonmark::tests
