#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>
#include <fstream>
#include <sstream>

#include "app/gui/docks/contributions/contributions_dock.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/gui/docks/study_form/what_form.h"
#include "app/gui/session/study/run_estimate.h"
#include "app/gui/tools/editing/building_editing.h"
#include "app/gui/tools/editing/tree_editing.h"
#include "core/city/trees/tree_facts.h"
#include "tests/gui/answers_window.h"

namespace noonmark {
namespace {

using test::waitFor;
using testing::HasSubstr;
using testing::Not;

/// The window with a place in the yard, and the dock of contributions in front.
struct ContributionsWindow : test::AnswersWindow {
    void SetUp() override {
        AnswersWindow::SetUp();
        Project next = session().project();
        next.places.push_back({"Yard", PlaceKind::park, {test::square({-40, 20}, 60)}, "drawn"});
        next.places.push_back({"Sandpit", PlaceKind::playground, {test::square({-10, 30}, 20)}, "drawn"});
        ASSERT_TRUE(session().change(std::move(next), QStringLiteral("places")));
        auto* toggle = window->findChild<QDockWidget*>(QStringLiteral("contributionsDock"));
        toggle->show();
        toggle->raise();
        ASSERT_TRUE(waitFor([&] { return dock().isVisible(); }));
    }
    ContributionsDock& dock() { return *window->findChild<ContributionsDock*>(); }
    ContributionLinks& links() { return window->contributions(); }
    QTableView& table() { return *dock().findChild<QTableView*>(QStringLiteral("contributionTable")); }
    QString headline() { return dock().findChild<QLabel*>(QStringLiteral("contributionHeadline"))->text(); }
    QString why() { return dock().findChild<QLabel*>(QStringLiteral("contributionNote"))->text(); }
    const ContributionSheet& sheet() { return dock().model().sheet(); }
    std::size_t coloured() { return window->panel().view().overlay().colouredCount(); }
    void ask(bool months, bool contributions, const std::string& engine = "horizon") {
        StudySettings settings = workbench().document().settings();
        settings.byMonth = months;
        settings.contributions = contributions;
        settings.engine = engine;
        workbench().document().change(settings, QStringLiteral("contributions"));
    }
    void choose(const std::string& place) {
        links().choose(place);
        ASSERT_TRUE(waitFor([&] { return !links().working().busy(); }));
    }
};

TEST_F(ContributionsWindow, TheStudyFormAsksForMonthsAndContributions) {
    auto* form = window->findChild<StudyDock*>();
    auto& months = *form->findChild<QCheckBox*>(QStringLiteral("byMonth"));
    auto& contributions = *form->findChild<QCheckBox*>(QStringLiteral("byBuilding"));
    EXPECT_FALSE(months.isChecked() || contributions.isChecked()) << "off by default";
    months.setChecked(true);
    contributions.setChecked(true);
    EXPECT_TRUE(workbench().document().settings().byMonth && workbench().document().settings().contributions);
    workbench().document().undoStack().undo();
    EXPECT_FALSE(contributions.isChecked());
    EXPECT_TRUE(months.isChecked());
}

TEST_F(ContributionsWindow, WhatTheMethodCannotSumIsDisabledAndSaysWhich) {
    auto* form = window->findChild<StudyDock*>();
    auto& months = *form->findChild<QCheckBox*>(QStringLiteral("byMonth"));
    auto& contributions = *form->findChild<QCheckBox*>(QStringLiteral("byBuilding"));
    const auto& line = *form->findChild<QLabel*>(QStringLiteral("whyNoBreakdown"));
    ask(false, false, "projected");
    EXPECT_TRUE(months.isEnabled());
    EXPECT_FALSE(contributions.isEnabled());
    EXPECT_THAT(line.text().toStdString(), HasSubstr("Horizon sweep"));
    ask(true, false, "ray");
    EXPECT_TRUE(months.isEnabled()) << "what is ticked can be unticked";
    months.setChecked(false);
    EXPECT_FALSE(months.isEnabled());
    EXPECT_THAT(line.text().toStdString(), HasSubstr("Projected shadows"));
    ask(false, false, "auto");
    EXPECT_TRUE(months.isEnabled() && contributions.isEnabled());
    EXPECT_TRUE(line.text().isEmpty());
}

TEST_F(ContributionsWindow, TheForecastCountsMonthsAndContributions) {
    const RunForecast& forecast = window->findChild<StudyDock*>()->forecast();
    const auto secondsOf = [&](bool months, bool contributions) {
        ask(months, contributions);
        EXPECT_TRUE(waitFor([&] { return forecast.estimate().has_value(); }));
        return forecast.estimate()->seconds;
    };
    const double alone = secondsOf(false, false), months = secondsOf(true, false),
                 both = secondsOf(true, true);
    EXPECT_GT(months, alone);
    EXPECT_GT(both, months);
}

TEST_F(ContributionsWindow, AStudyWithContributionsListsTheBuildingsOfTheWholeRegion) {
    ask(true, true);
    study();
    ASSERT_FALSE(sheet().rows.empty()) << why().toStdString();
    double share = 0;
    for (const ContributionRow& row : sheet().rows) share += row.share;
    EXPECT_NEAR(share, 1, 1e-9);
    EXPECT_EQ(sheet().months.groups.size(), 2U) << "March and April";
    EXPECT_EQ(sheet().months, makeMonthBars(*workbench().study())) << "as on the answer sheet";
    EXPECT_THAT(headline().toStdString(), HasSubstr(sheet().rows.front().name.toStdString()));
    EXPECT_EQ(coloured(), sheet().rows.size());
}

TEST_F(ContributionsWindow, AClickedPlaceIsAttributedAndAddsUpToTheStudysFigure) {
    ask(false, false);
    study();
    EXPECT_TRUE(sheet().rows.empty());
    EXPECT_TRUE(dock().findChild<QPushButton*>(QStringLiteral("attribute"))->isVisible());
    choose("Yard");
    ASSERT_TRUE(links().shown()) << why().toStdString();
    double attributed = 0;
    for (const Contribution& row : links().shown()->rows) attributed += row.attributedMinM2;
    EXPECT_GT(attributed, 0);
    EXPECT_NEAR(attributed / links().shown()->studyMinM2, 1, 1e-6);
    EXPECT_EQ(sheet().months.groups.size(), 2U) << "a place has its months without asking";
    const auto first = links().shown();
    choose("Sandpit");
    EXPECT_LT(links().shown()->cells, first->cells);
    links().choose("Yard");
    EXPECT_EQ(links().shown(), first) << "kept until the study changes";
}

TEST_F(ContributionsWindow, SentencesAreAboutSunWhereTheLegendShowsSun) {
    ask(false, false);
    study();
    choose("Yard");
    ASSERT_TRUE(links().shown()) << why().toStdString();
    EXPECT_THAT(headline().toStdString(), HasSubstr("min a day in shadow"));
    window->findChild<QToolButton*>(QStringLiteral("showSun"))->click();
    const double minutes = links().shown()->studyMinM2 /
                           (double(links().shown()->cells) * links().shown()->breakdown.grid.cellAreaM2() *
                            double(links().shown()->days));
    const double hours = (workbench().study()->field.sunlitMinutesPerDay - minutes) / 60;
    EXPECT_THAT(headline().toStdString(), HasSubstr(fmt::format("{:.1f}", hours).substr(0, 3)));
    EXPECT_THAT(headline().toStdString(), HasSubstr(" h of sun a day, "));
    EXPECT_THAT(headline().toStdString(), Not(HasSubstr("min a day in shadow")));
    EXPECT_THAT(why().toStdString(), HasSubstr(" h of sun a day"));
}

TEST_F(ContributionsWindow, TheWholeRegionIsAttributedByTheButton) {
    study();
    dock().findChild<QPushButton*>(QStringLiteral("attribute"))->click();
    ASSERT_TRUE(waitFor([&] { return !sheet().rows.empty(); })) << why().toStdString();
    EXPECT_EQ(links().shown()->cells, workbench().study()->receivers.cells.size());
}

TEST_F(ContributionsWindow, RowsAndBuildingsOfTheViewSelectEachOther) {
    ask(false, true);
    study();
    ASSERT_GT(sheet().rows.size(), 1U);
    const auto& buildings = workbench().city()->city().buildings;
    table().selectRow(1);
    ASSERT_TRUE(window->tools().building().selected());
    EXPECT_EQ(buildings[*window->tools().building().selected()], sheet().rows[1].building);
    window->tools().building().select(std::nullopt);
    EXPECT_FALSE(table().selectionModel()->hasSelection());
    const auto other = std::ranges::find(buildings, sheet().rows[0].building) - buildings.begin();
    window->tools().building().select(std::uint32_t(other));
    EXPECT_EQ(table().currentIndex().row(), 0);
    const CameraPose before = window->panel().view().pose();
    Q_EMIT table().activated(table().currentIndex());
    EXPECT_NE(window->panel().view().pose().distanceM, before.distanceM);
}

TEST_F(ContributionsWindow, ATreesRowChoosesTheTreeAndLeadsToIt) {
    Project next = session().project();
    City city = *next.city;
    Trees trees{.trees = {}, .leafDays = {100, 300}};
    for (const double x : {-50.0, 40.0}) {
        trees.trees.push_back(completeTree({.sourceId = "tree " + std::to_string(trees.trees.size()),
                                            .species = "Platanus",
                                            .heightM = 14,
                                            .crownDiameterM = 10}));
        trees.trees.back().place = {x, 40};
    }
    city.trees = std::make_shared<const Trees>(std::move(trees));
    next.city = std::make_shared<const City>(std::move(city));
    ASSERT_TRUE(session().change(std::move(next), QStringLiteral("trees")));
    ASSERT_TRUE(waitFor([&] { return workbench().city()->city().trees != nullptr; }));
    ask(false, true);
    study();
    const auto rowOf = [&](const char* id) { return dock().model().rowOfTree(id); };
    ASSERT_GE(rowOf("tree 0"), 0) << headline().toStdString();
    ASSERT_GE(rowOf("tree 1"), 0);
    TreeEditing& editing = window->tools().trees();
    window->tools().building().select(0);
    table().selectRow(rowOf("tree 1"));
    EXPECT_EQ(editing.chosenIds(), (std::set<std::string>{"tree 1"}));
    EXPECT_FALSE(window->tools().building().selected()) << "one thing is chosen";
    EXPECT_EQ(table().currentIndex().row(), rowOf("tree 1")) << "its row stays selected";
    EXPECT_TRUE(table().selectionModel()->hasSelection());
    Q_EMIT table().activated(table().currentIndex());
    const CameraPose pose = window->panel().view().pose();
    EXPECT_NEAR(pose.target.x, 40, 5);
    EXPECT_NEAR(pose.target.y, 40, 25) << "seen slanting";
    // A building's row lets the tree go; so does the tree's id asked for elsewhere the building.
    for (int row = 0; row < table().model()->rowCount(); ++row)
        if (sheet().rows[std::size_t(row)].building) table().selectRow(row);
    EXPECT_TRUE(editing.chosenIds().empty());
    EXPECT_TRUE(window->tools().building().selected());
    links().show(QStringLiteral("tree 0"));
    EXPECT_EQ(editing.chosenIds(), (std::set<std::string>{"tree 0"}));
    EXPECT_NEAR(window->panel().view().pose().target.x, -50, 5);
    links().show(QString::fromStdString(test::idOf(session().project(), 2)));
    ASSERT_TRUE(window->tools().building().selected());
    EXPECT_EQ(*window->tools().building().selected(), 2U);
}

TEST_F(ContributionsWindow, ColoursGoWithTheirBoxAndWithTheDock) {
    ask(false, true);
    study();
    ASSERT_GT(coloured(), 0U);
    auto& box = *dock().findChild<QCheckBox*>(QStringLiteral("colourBuildings"));
    box.setChecked(false);
    EXPECT_EQ(coloured(), 0U);
    box.setChecked(true);
    EXPECT_GT(coloured(), 0U);
    auto* dock = window->findChild<QDockWidget*>(QStringLiteral("contributionsDock"));
    window->findChild<QDockWidget*>(QStringLiteral("resultsDock"))->raise();
    QCoreApplication::processEvents();
    EXPECT_EQ(coloured(), 0U) << "behind another tab";
    dock->raise();
    QCoreApplication::processEvents();
    EXPECT_GT(coloured(), 0U);
    dock->close();
    EXPECT_EQ(coloured(), 0U);
}

TEST_F(ContributionsWindow, TheTableSortsByNumbersNotByTheirTexts) {
    ask(false, true);
    study();
    table().sortByColumn(1, Qt::AscendingOrder);
    double last = -1;
    for (int row = 0; row < table().model()->rowCount(); ++row) {
        const double value = table().model()->index(row, 1).data(ContributionModel::valueRole).toDouble();
        EXPECT_GE(value, last);
        last = value;
    }
}

TEST_F(ContributionsWindow, AComparisonListsWhatEachNewBuildingAddsAlone) {
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([&] { return workbench().city()->city().buildings.size() == 4; }));
    workbench().run();
    ASSERT_TRUE(waitFor([&] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    ASSERT_EQ(sheet().rows.size(), 1U);
    EXPECT_EQ(sheet().rows[0].name, QStringLiteral("New"));
    EXPECT_GT(sheet().rows[0].values[1], 0);
    EXPECT_DOUBLE_EQ(sheet().rows[0].share, 1);
    const double region = sheet().rows[0].values[2];
    links().choose("Yard");
    EXPECT_LE(sheet().rows[0].values[2], region);
    EXPECT_FALSE(links().working().busy()) << "it is known already";
}

TEST_F(ContributionsWindow, AnEngineWithoutAttributionIsNamedWithThoseThatHaveIt) {
    ask(false, false, "projected");
    study();
    choose("Yard");
    EXPECT_THAT(why().toStdString(), HasSubstr("horizon"));
    EXPECT_TRUE(sheet().rows.empty());
}

TEST_F(ContributionsWindow, APlaceOutsideTheStudySaysSo) {
    study();
    Project next = session().project();
    next.places.push_back({"Far", PlaceKind::park, {test::square({2000, 2000}, 50)}, "drawn"});
    ASSERT_TRUE(session().change(std::move(next), QStringLiteral("place")));
    choose("Far");
    EXPECT_THAT(why().toStdString(), HasSubstr("Far"));
}

TEST_F(ContributionsWindow, ASavedStudyShowsWhatBuildingsTakeFromItsRegion) {
    ask(false, true);
    study();
    keep("March");
    const ContributionSheet before = sheet();
    ASSERT_FALSE(before.rows.empty());
    showSaved("March");
    ASSERT_EQ(sheet().rows.size(), before.rows.size());
    EXPECT_EQ(sheet().rows[0].name, before.rows[0].name);
    EXPECT_EQ(sheet().rows[0].building, before.rows[0].building);
    EXPECT_NEAR(sheet().rows[0].share, before.rows[0].share, 1e-6);
    EXPECT_EQ(sheet().headline, before.headline);
}

TEST_F(ContributionsWindow, ASavedResultInFrontIsNotMistakenForTheStudyBehindIt) {
    ask(false, false);
    study();
    keep("Without");
    ask(false, true);
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return workbench().study()->settings.contributions; }));
    EXPECT_FALSE(sheet().rows.empty());
    showSaved("Without");
    EXPECT_TRUE(sheet().rows.empty());
    EXPECT_THAT(why().toStdString(), HasSubstr("saved result"));
    workbench().showStudyAgain();
    EXPECT_FALSE(sheet().rows.empty());
}

TEST_F(ContributionsWindow, AnotherStudyDropsWhatIsKnown) {
    study();
    choose("Yard");
    ASSERT_TRUE(links().shown());
    ask(true, false);
    const auto before = workbench().study();
    workbench().run();
    ASSERT_TRUE(waitFor([&] { return workbench().study() != before; }));
    EXPECT_FALSE(links().shown());
}

TEST_F(ContributionsWindow, ThePlaceIsExportedAsTablesAndLayer) {
    study();
    choose("Yard");
    ExportChoice choice;
    choice.subject = ExportChoice::Subject::place;
    EXPECT_TRUE(workbench().filesOf(choice).contains(QStringLiteral("contributions.gpkg")));
    const std::filesystem::path out = folder.filePath(QStringLiteral("out")).toStdString();
    workbench().exportShown(out, choice);
    ASSERT_TRUE(waitFor([&] { return !workbench().writing().busy(); }))
        << window->panel().messages().text().toStdString();
    std::ostringstream text;
    text << std::ifstream(out / "contributions.csv").rdbuf();
    const std::string csv = text.str();
    EXPECT_EQ(std::size_t(std::ranges::count(csv, '\n')), 1 + links().shown()->rows.size());
    EXPECT_GT(std::filesystem::file_size(out / "contributions.gpkg"), 1000U);
    EXPECT_TRUE(std::filesystem::exists(out / "by_month.csv"));
}

TEST(PlaceAtPoint, TheSmallestPlaceThatContainsThePointIsMeant) {
    const std::vector<Place> places{{"Park", PlaceKind::park, {test::square({0, 0}, 100)}, "drawn"},
                                    {"Pit", PlaceKind::playground, {test::square({40, 40}, 10)}, "drawn"}};
    EXPECT_EQ(findPlaceAt(places, {45, 45})->name, "Pit");
    EXPECT_EQ(findPlaceAt(places, {10, 10})->name, "Park");
    EXPECT_EQ(findPlaceAt(places, {-1, 10}), nullptr);
}

// 60 minutes of a building, and of a tree 40 as an evergreen or 20 with its season, of 400 with the sun up.
TEST(ContributionSheets, ListTreesWithTheBuildingsAndStateBothTimes) {
    const auto taking = [](const char* id, double minutes, bool isTree) {
        Contribution one;
        one.id = id;
        one.attributedMinM2 = one.attributedMin = minutes;
        one.isTree = isTree;
        return one;
    };
    ContributionTable of{.place = "Yard", .cells = 10, .sunlitMinutesPerDay = 400};
    of.rows = {taking("house", 60, false)};
    of.rows[0].share = 1;
    const City city;
    const ContributionSheet bare = makeContributionSheet(of, city, {});
    EXPECT_EQ(bare.headline.toStdString(),
              "60 min a day in shadow, 15 % of the sunlit time. 1 building shades it; house takes the most, "
              "100 %.");
    of.trees = {{0,
                 {{TreeColumns::evergreen, taking("lime", 90, true)},
                  {TreeColumns::seasonal, taking("lime", 20, true)}}}};
    const ContributionSheet seasonal = makeContributionSheet(of, city, {});
    ASSERT_EQ(seasonal.rows.size(), 2U);
    EXPECT_EQ(seasonal.rows[1].name.toStdString(), "Tree lime");
    EXPECT_EQ(seasonal.rows[1].tree, "lime");
    EXPECT_TRUE(seasonal.rows[0].tree.empty());
    EXPECT_DOUBLE_EQ(seasonal.rows[1].share, 0.25);
    EXPECT_TRUE(seasonal.areTreesListed);
    EXPECT_THAT(seasonal.headline.toStdString(),
                testing::AllOf(
                    HasSubstr("80 min a day in shadow, 20 % of the sunlit time (trees with their seasons)"),
                    HasSubstr("; 60 min a day in shadow, 15 % of the sunlit time (without trees)"),
                    HasSubstr("house takes the most, 75 %"), HasSubstr("sun from it, 25 % of the shadow")));
    const ContributionSheet evergreen =
        makeContributionSheet(of, city, {.show = ShownAs::shadow, .trees = TreeColumns::evergreen});
    EXPECT_EQ(evergreen.rows[0].name.toStdString(), "Tree lime") << "it takes more than the house";
}

TEST(ContributionSheets, BuildingsWithoutAReadableNameAreDescribed) {
    for (const char* name : {"", "{0C3309A9-671F-4F25-8321-5EDF03882E91}", "2O2Fr$t4X7Zf8NOew3FLOH",
                             "0c3309a9-671f-4f25-8321-5edf03882e91"})
        EXPECT_FALSE(isReadableName(name)) << name;
    for (const char* name : {"Tower 1", "432 Park Avenue", "Donaudampfschifffahrtsgesellschaft"})
        EXPECT_TRUE(isReadableName(name)) << name;

    Building hall{.sourceId = "{0C3309A9-671F-4F25-8321-5EDF03882E91}"};
    hall.parts.emplace_back();
    hall.parts[0].footprint.outer = {{100, -10}, {120, -10}, {120, 10}, {100, 10}};
    hall.parts[0].topM = 23;
    City city;
    city.buildings.push_back(std::make_shared<const Building>(hall));
    ContributionTable of{.place = "Yard", .cells = 10, .sunlitMinutesPerDay = 400};
    of.rows.emplace_back();
    of.rows[0].id = hall.sourceId;
    of.rows[0].attributedMin = 60;
    of.rows[0].share = 1;
    const ContributionSheet sheet = makeContributionSheet(of, city, {.from = glm::dvec2(0, 0)});
    EXPECT_EQ(sheet.rows[0].name.toStdString(), "23 m high, 110 m E");
    EXPECT_THAT(sheet.headline.toStdString(), HasSubstr("a building 23 m high, 110 m E takes the most"));
}

TEST_F(ContributionsWindow, TheViewShowsWhoShadesThePlaceThatIsChosen) {
    ask(false, false);
    study();
    CityView& view = window->panel().view();
    window->panel().navigator().show({{-12, 28}, {-8, 32}});
    choose("Yard");
    ASSERT_FALSE(sheet().rows.empty());
    ASSERT_TRUE(sheet().rows.front().building);
    const Box2 box = bounds(*sheet().rows.front().building);
    const glm::dvec2 middle = (glm::dvec2(box.low) + glm::dvec2(box.high)) * 0.5;
    EXPECT_TRUE(waitFor([&] {
        const auto pixel = pixelOf(view.pose(), view.lens(), glm::dvec3(middle, 0));
        return pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x <= view.lens().widthPx &&
               pixel->y <= view.lens().heightPx;
    }));
}

TEST(ContributionClasses, EachShareHasTheColourOfItsClass) {
    EXPECT_EQ(classOf(0), 0U);
    EXPECT_EQ(classOf(0.01), 1U);
    EXPECT_EQ(classOf(0.1499), 2U);
    EXPECT_EQ(classOf(1), 4U);
    EXPECT_EQ(describeClass(1).toStdString(), "1-5 %");
}

}  // namespace
}  // namespace noonmark
