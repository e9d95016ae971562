#include "app/report/maps/change_scale.h"

#include <gtest/gtest.h>

#include "app/report/maps/answer_legends.h"
#include "app/report/sheets/answer_reports.h"
#include "tests/report/synthetic_study.h"

namespace noonmark {
namespace {

TEST(ChangeScales, AreReadAndWrittenAndRefusedWhereTheyAreNone) {
    for (const char* text : {"60", "0.5", "1440", "auto"})
        EXPECT_EQ(formatText(parseChangeScale(text).value()), text);
    for (const char* text : {"", "0", "-60", "1441", "60 min", "60,5", "nan", "inf", "Auto", " 60"})
        EXPECT_FALSE(parseChangeScale(text)) << text;
    EXPECT_EQ(changeScaleIn({}), ChangeScale{60});
    EXPECT_EQ(changeScaleIn({{"change_scale", "auto"}}), ChangeScale{std::nullopt});
    EXPECT_EQ(changeScaleIn({{"change_scale", "much"}}), ChangeScale{60})
        << "the file may come from anywhere";
}

/// One row of cells with the given changes.
Impact impactOf(const std::vector<float>& minutes) {
    Impact impact;
    impact.grid = {0, 0, 1, int(minutes.size()), 1};
    impact.grossMin = impact.continuousMin = minutes;
    impact.change.assign(minutes.size(), CellChange::none);
    impact.sunlitMinutesPerDay = 400;
    return impact;
}

TEST(ChangeScales, LockedTheColoursOfTwoProposalsAreTheSame) {
    const Impact small = impactOf({0, 10, 20}), large = impactOf({0, 10, 230});
    const auto legend = [](const Impact& impact, const ChangeScale& scale) {
        return makeLegend(impact, ShadowMeasure::gross, scale);
    };
    EXPECT_EQ(legend(small, {}).scale.top, 60);
    EXPECT_EQ(legend(large, {}).scale.top, 60);
    EXPECT_EQ(describeUnit(legend(large, {})),
              QStringLiteral("min a day, scale locked: ±60 min, largest 230"));
    const ColourScale colours = coloursOf(legend(small, {}));
    EXPECT_EQ(pickColour(small, ShadowMeasure::gross, 1, colours),
              pickColour(large, ShadowMeasure::gross, 1, coloursOf(legend(large, {}))));
    EXPECT_EQ(pickColour(small, ShadowMeasure::gross, 0, colours), std::nullopt);
    EXPECT_EQ(legend(small, {25}).scale.top, 25) << "exactly what was asked for";
    EXPECT_EQ(legend(small, {7}).scale.top, 7);
    const ChangeScale fitted{std::nullopt};
    const Impact even = impactOf(std::vector<float>(200, 20));
    EXPECT_EQ(legend(even, fitted).scale.top, 20);
    EXPECT_EQ(describeUnit(legend(even, fitted)),
              QStringLiteral("min a day, scale fitted to this difference"));
}

TEST(ChangeScales, AreStatedOnTheSheetOfAComparison) {
    const Study study = tests::syntheticStudy();
    ImpactAnswer answer{.from = "Existing", .to = "Tower", .settings = {study.settings}};
    answer.study.sun = study.sun;
    answer.study.before = answer.study.after = study.field;
    answer.study.total = impactOf(study.field.grossMin);
    answer.study.total.grid = study.field.grid;
    const auto stated = [&](const ChangeScale& scale) {
        return makeSheet(answer, {study.city}, scale).definitions.at(0).text;
    };
    EXPECT_TRUE(stated({}).contains(QStringLiteral("scale locked: ±60")));
    EXPECT_TRUE(stated({std::nullopt}).contains(QStringLiteral("scale fitted to this difference")));
}

}  // namespace
}  // namespace noonmark
