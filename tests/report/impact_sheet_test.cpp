#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "app/report/book/answer_books.h"
#include "app/report/sheets/answer_reports.h"
#include "core/study/review_study.h"
#include "tests/report/book/book_texts.h"
#include "tests/scenarios/small_town.h"

namespace noonmark {
namespace {

using namespace tests;

/// Three houses in a region of 1.2 km, and a tower of 62 m beside them.
class ComparedTower {
public:
    explicit ComparedTower(const std::string& name = "Mill Tower") {
        before = threeHouses();
        after = before;
        after.buildings.push_back(shared(house(name, box(0, 40, 20, 60), 62)));
        ImpactSettings settings;
        settings.study.region = makeRegionFromLocalBox({{-600, -600}, {600, 600}});
        settings.study.receivers.cellM = 8;
        settings.study.period = {.hours = 3, .stepMinutes = 30, .zone = "America/New_York"};
        settings.thresholdsMin = {10};
        NoProgress progress;
        answer = {"Existing", name,
                  settings,   runImpact(before, after, settings, progress, {}).value(),
                  {},         keepOwnBuildings(after, before)};
    }

    City before, after;
    ImpactAnswer answer;
};

TEST(ImpactSheet, IsZoomedOnTheChangeAndNamesTheTowerWithItsHeight) {
    const ComparedTower tower;
    const Sheet sheet = makeSheet(tower.answer, {tower.after}, {});
    ASSERT_TRUE(sheet.map.scene.shown);
    const Box2 shown = shownGround(sheet.map.scene);
    EXPECT_LT(shown.high.x - shown.low.x, 900) << "not all of the region";
    EXPECT_LE(shown.low.x, 0);
    EXPECT_GE(shown.high.y, 60) << "the tower";
    ASSERT_NE(sheet.map.scene.proposal, nullptr);
    EXPECT_EQ(sheet.map.scene.proposal->buildings.size(), 1U);
    EXPECT_EQ(sheet.figures.back().value, QStringLiteral("Mill Tower, 62 m high"));
}

TEST(ImpactSheet, ShowsTheChangeWhereNoCellReachesTheThreshold) {
    ComparedTower tower;
    const Box2 all = shownGround(makeSheet(tower.answer, {tower.after}, {}).map.scene);
    tower.answer.settings.thresholdsMin = {1000};
    const Box2 shown = shownGround(makeSheet(tower.answer, {tower.after}, {}).map.scene);
    EXPECT_NEAR(shown.high.y, all.high.y, 100) << "the shadow north of the tower, too";
}

// A cell with 8 min more, which is coloured, beside others with more than an hour.
TEST(ImpactSheet, HoldsAllOfTheChangeThatItsColoursShow) {
    ComparedTower tower;
    Impact& impact = tower.answer.study.total;
    ASSERT_GT(std::ranges::max(impact.grossMin, {}, [](float min) { return std::isnan(min) ? 0 : min; }), 80);
    const glm::dvec2 at{-304, 48};
    const Grid& grid = impact.grid;
    impact
        .grossMin[grid.index(int((at.x - grid.westM) / grid.cellM), int((at.y - grid.southM) / grid.cellM))] =
        8;
    const Box2 shown = shownGround(makeSheet(tower.answer, {tower.after}, {}).map.scene);
    EXPECT_LT(shown.low.x, at.x);
}

TEST(ImpactSheet, BothMeasuresAndTheFiguresAreOnOnePage) {
    const ComparedTower tower;
    for (const bool landscape : {false, true}) {
        const Book book = makeImpactBook(tower.answer, {tower.after}, {}, {.setup = {Paper::a4, landscape}});
        std::size_t maps = 0, tables = 0;
        const auto& items = book.pages.front().items;
        for (const PageItem& item : items) {
            maps += std::holds_alternative<PageMap>(item.content);
            tables += std::holds_alternative<PageTable>(item.content);
            EXPECT_TRUE(contentArea(book.setup).adjusted(-1, -1, 1, 1).contains(item.area));
            for (const PageItem& other : items)
                EXPECT_TRUE(&item == &other || !item.area.adjusted(1, 1, -1, -1).intersects(other.area));
        }
        EXPECT_EQ(maps, 2U);
        EXPECT_EQ(tables, 1U);
        EXPECT_THAT(listMeetings(textsOfPage(book, 0)), testing::IsEmpty());
    }
}

TEST(ImpactSheet, StatesItsFindingInASentenceAndShowsTheHeightOnTheMap) {
    const ComparedTower tower;
    const Sheet sheet = makeSheet(tower.answer, {tower.after}, {});
    EXPECT_THAT(sheet.finding.toStdString(), testing::EndsWith("."));
    const QString text = textOfPage(makeImpactBook(tower.answer, {tower.after}, {}, {}), 0);
    EXPECT_TRUE(text.contains(QStringLiteral("62 m"))) << text.toStdString();
    EXPECT_TRUE(text.contains(sheet.finding.section(u' ', 0, 2))) << text.toStdString();
}

// "0 min of sun a day on average" says nothing of a small change in a large region.
TEST(ImpactSheet, StatesTheAreaThatLosesSunWhereTheMeanIsNothing) {
    ComparedTower tower;
    Impact& impact = tower.answer.study.total;
    for (float& change : impact.grossMin)
        if (change != 0) change = 0;
    const std::size_t cell = impact.grid.index(3, 1);
    ASSERT_FALSE(std::isnan(impact.grossMin[cell]));
    impact.grossMin[cell] = 40;
    const Sheet sheet = makeSheet(tower.answer, {tower.after}, {});
    EXPECT_EQ(sheet.finding,
              QStringLiteral("Mill Tower takes sun from 64 m², at most 40 min a day at one spot."))
        << sheet.finding.toStdString();
    impact.grossMin[impact.grid.index(3, 0)] = 40;
    const QString beyond = makeSheet(tower.answer, {tower.after}, {}).finding;
    EXPECT_TRUE(beyond.endsWith(QStringLiteral("reaches the region's edge: beyond it is not measured.")))
        << beyond.toStdString();
}

TEST(ImpactSheet, OfNoChangeShowsTheWholeRegion) {
    ComparedTower tower;
    NoProgress progress;
    tower.answer.study = runImpact(tower.before, tower.before, tower.answer.settings, progress, {}).value();
    tower.answer.proposal = {};
    const Sheet sheet = makeSheet(tower.answer, {tower.before}, {});
    EXPECT_FALSE(sheet.map.scene.shown);
    EXPECT_EQ(sheet.map.scene.proposal, nullptr);
}

TEST(ImpactSheet, OfAnyNameLaysNoTextOverAnother) {
    for (const char* name : {"The Honourable Society's Memorial Tower and Winter Garden of Saint-Michel",
                             "Donaudampfschifffahrtsgesellschaftsverwaltungsgebäudeerweiterungsbau"}) {
        const ComparedTower tower(name);
        for (const bool landscape : {false, true}) {
            const Book book =
                makeImpactBook(tower.answer, {tower.after}, {}, {{Paper::a4, landscape}, {}, {}});
            for (std::size_t i = 0; i < book.pages.size(); ++i)
                EXPECT_THAT(listMeetings(textsOfPage(book, i)), testing::IsEmpty()) << "page " << i;
        }
    }
}

}  // namespace
}  // namespace noonmark
