#include "app/report/book/study_books.h"

#include <gtest/gtest.h>

#include "app/report/book/print_book.h"
#include "tests/report/synthetic_study.h"

namespace noonmark {
namespace {

BuildingShadow shadowOf(std::uint32_t building, double attributedM2h, double soleM2h) {
    return {building, {attributedM2h * 60 / 3, attributedM2h * 60 * 2 / 3}, {soleM2h * 60, 0}};
}

Building tower(const std::string& name, float west) {
    Part part;
    part.footprint.outer = {{west, 0}, {west + 8, 0}, {west + 8, 8}, {west, 8}};
    part.topM = 30;
    return {.sourceId = "way 7", .name = name, .parts = {part}};
}

/// Attributed: 100 m2 h of "Large", 899.4 of "Larger", 0.6 of one that is left out, 1,000 of the terrain.
Study studyWithContributions() {
    Study study = tests::syntheticStudy();
    study.city.buildings = {std::make_shared<Building>(tower("Large", 10)),
                            std::make_shared<Building>(tower("", 30)),
                            std::make_shared<Building>(tower("Larger", 50))};
    ShadowBreakdown breakdown;
    breakdown.grid = study.field.grid;
    breakdown.buildings = {shadowOf(0, 100, 60), shadowOf(1, 0.6, 0.6), shadowOf(2, 899.4, 800)};
    breakdown.terrain = shadowOf(0, 1000, 900);
    study.breakdown = breakdown;
    return study;
}

TEST(ContributionBook, RowsAddUpToAllShadow) {
    const Study study = studyWithContributions();
    const Book book = makeContributionBook(study, {});
    const auto& table = std::get<PageTable>(book.pages.back().items.back().content);
    std::vector<std::string> rows;
    for (const auto& row : table.rows)
        rows.push_back(QStringList(row.begin(), row.end()).join(u'|').toStdString());
    const std::vector<std::string> expected{
        "1|Larger|44.97 %|899 m² h|800 m² h", "2|Large|5 %|100 m² h|60 m² h",
        "|Other buildings: 1|0.03 %|1 m² h|", "|Terrain|50 %|1,000 m² h|900 m² h",
        "|All shadow|100 %|2,000 m² h|"};
    EXPECT_EQ(rows, expected);
}

TEST(ContributionBook, HasTheLegendThatWasChosen) {
    const Study study = studyWithContributions();
    const Book book = makeContributionBook(study, {.legend = {.show = ShownAs::sun, .ramp = Ramp::viridis}});
    const Legend& legend = std::get<PageMap>(book.pages.front().items.front().content).map->legend;
    EXPECT_EQ(legend.title, QStringLiteral("Hours of sun"));
    EXPECT_EQ(legend.colours->ramp, Ramp::viridis);
}

TEST(ContributionBook, NumbersStandOnTheirBuildings) {
    const Study study = studyWithContributions();
    const Book book = makeContributionBook(study, {});
    const auto& map = std::get<PageMap>(book.pages.front().items.front().content).map;
    ASSERT_EQ(map->scene.marks.size(), 2U);
    EXPECT_EQ(map->scene.marks[0].text, QStringLiteral("1"));
    EXPECT_GT(map->scene.marks[0].at.x, 50);
    EXPECT_LT(map->scene.marks[0].at.x, 58);
    EXPECT_LT(map->scene.marks[1].at.x, 18);
    EXPECT_TRUE(printBook(book));
}

TEST(ContributionBook, NothingInShadowIsStillABook) {
    Study study = studyWithContributions();
    study.breakdown->buildings.clear();
    study.breakdown->terrain.reset();
    EXPECT_TRUE(printBook(makeContributionBook(study, {})));
}

}  // namespace
}  // namespace noonmark
