#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QMenu>

#include "app/gui/docks/project/saved_views.h"
#include "app/gui/session/project/project_changes.h"
#include "app/gui/view/panel/view_presets.h"
#include "app/gui/view/time/sun_at_moment.h"
#include "app/gui/view/time/time_strip.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::ProjectWindow;
using test::waitFor;

QStringList entriesOf(const QMenu& menu) {
    QStringList texts;
    for (const QAction* action : menu.actions()) texts << action->text();
    return texts;
}

TEST(ViewPresets, LookTowardsTheOppositeOfWhereTheyStand) {
    const CameraPose pose{{10, 20, 3}, 500, 33, 45};
    const CameraPose south = lookFromSide(pose, 180);
    EXPECT_EQ(south.headingDeg, 0) << "from the south, north is ahead";
    EXPECT_EQ(lookFromSide(pose, 270).headingDeg, 90);
    EXPECT_LT(south.pitchDeg, 15);
    EXPECT_EQ(south.target, pose.target);
    EXPECT_EQ(south.distanceM, pose.distanceM);
}

TEST(ViewPresets, AreElevationsInAParallelProjection) {
    CameraPose pose{{10, 20, 3}, 500, 33, 45};
    pose.projection = Projection::parallel;
    const CameraPose west = lookFromSide(pose, 270);
    EXPECT_EQ(west.headingDeg, 90);
    EXPECT_EQ(west.pitchDeg, 0) << "level";
    // The ground lies below the middle: 3 m of 0.36 x 500 m up and down.
    const ViewLens lens{40, 1200, 800};
    const auto ground = pixelOf(west, lens, {10, 20, 3});
    ASSERT_TRUE(ground);
    EXPECT_GT(ground->y, 560);
    EXPECT_LT(ground->y, 720);
}

TEST_F(ProjectWindow, PlanAndProjectionFollowTheMenu) {
    const auto trigger = [this](QAction* action) { action->trigger(); };
    CityView& view = window->panel().view();
    QAction* parallel = window->presets().parallel();
    EXPECT_FALSE(parallel->isChecked());
    trigger(window->presets().actions().first());
    EXPECT_TRUE(parallel->isChecked());
    EXPECT_EQ(view.pose().projection, Projection::parallel);
    EXPECT_EQ(view.pose().pitchDeg, 90);
    // The scale bar: pixels a metre by two points on the ground and one on a roof.
    const auto a = pixelOf(view.pose(), view.lens(), {0, 0, 0}),
               b = pixelOf(view.pose(), view.lens(), {50, 0, 30});
    EXPECT_NEAR(window->panel().legend().pixelsPerM(), (b->x - a->x) / 50, 1e-6);
    window->panel().navigator().showWholeCity();
    EXPECT_EQ(view.pose().projection, Projection::parallel) << "stays";
    trigger(parallel);
    EXPECT_FALSE(parallel->isChecked());
    EXPECT_EQ(view.pose().projection, Projection::perspective);
}

TEST_F(ProjectWindow, BuildingsHaveTheColourOfTheSourceOfTheirHeight) {
    QAction* action = nullptr;
    for (const QMenu* menu : window->findChildren<QMenu*>())
        for (QAction* entry : menu->actions())
            if (entry->objectName() == QStringLiteral("colourByHeightSource")) action = entry;
    auto* legend = window->findChild<QLabel*>(QStringLiteral("heightSourceLegend"));
    ASSERT_TRUE(action && legend);
    const OverlayBodies& overlay = window->panel().view().overlay();
    const auto coloured = [&] { return overlay.colouredCount(OverlayBodies::ColouredBy::heightSource); };
    EXPECT_TRUE(legend->isHidden());
    action->trigger();
    EXPECT_EQ(coloured(), 3U);
    EXPECT_FALSE(legend->isHidden());
    EXPECT_TRUE(legend->text().contains(QStringLiteral("measured 3"))) << legend->text().toStdString();
    EXPECT_FALSE(legend->text().contains(QStringLiteral("assumed"))) << "no building is";
    build();  // a tower that counts as measured
    EXPECT_EQ(coloured(), 4U);
    EXPECT_TRUE(legend->text().contains(QStringLiteral("measured 4"))) << legend->text().toStdString();
    action->trigger();
    EXPECT_EQ(coloured(), 0U);
    EXPECT_TRUE(legend->isHidden());
}

TEST_F(ProjectWindow, AViewIsSavedFoundRenamedAndDeleted) {
    CityView& view = window->panel().view();
    CameraPose pose{{5, 6, 0}, 300, 20, 60};
    pose.projection = Projection::parallel;
    window->panel().navigator().go(pose);
    const CameraPose saved = view.pose();
    window->panel().time().choose(
        {ShownSpan::moment, CivilDate{std::chrono::year{2026}, std::chrono::June, std::chrono::day{21}},
         std::chrono::minutes(15 * 60)});
    const ShownTime look = window->panel().time().look();
    const SectionBox box{{-20, -10, -1}, {40, 50, 30}};
    window->panel().section().set(box);
    window->savedViews().save();
    ASSERT_EQ(session().project().views.size(), 1U);
    const std::string name = session().project().views[0].name;
    EXPECT_TRUE(session().hasUnsavedWork());
    window->panel().navigator().go({{0, 0, 0}, 900, 0, 40});
    window->panel().time().choose({ShownSpan::moment, look.date, std::chrono::minutes(9 * 60)});
    window->panel().section().set(std::nullopt);
    window->savedViews().show(name);
    EXPECT_EQ(window->panel().section().box(), box);
    EXPECT_EQ(view.pose(), saved);
    EXPECT_EQ(window->panel().time().look(), look);
    ASSERT_TRUE(session().rename(ProjectPart::view, name, "Plaza"));
    const auto fewer = without(session().project(), ProjectPart::view, "Plaza");
    ASSERT_TRUE(session().change(*fewer, QStringLiteral("delete")));
    EXPECT_TRUE(session().project().views.empty());
    workbench().document().undoStack().undo();
    ASSERT_EQ(session().project().views.size(), 1U);
    EXPECT_EQ(session().project().views[0].name, "Plaza");
    save();
    open(file);
    EXPECT_EQ(session().project().views.size(), 1U);
    QMenu& menu = *window->savedViews().menu();
    Q_EMIT menu.aboutToShow();
    EXPECT_THAT(entriesOf(menu).join(QLatin1Char('|')).toStdString(), testing::HasSubstr("Plaza"));
}

TEST_F(ProjectWindow, AViewOfTheWholeCityRemovesTheSectionBox) {
    window->savedViews().save();
    window->panel().section().set(SectionBox{{-20, -10, -1}, {40, 50, 30}});
    window->savedViews().show(session().project().views[0].name);
    EXPECT_FALSE(window->panel().section().box());
}

TEST(ViewPresets, TheSunsViewIsAlongItsRays) {
    SunAtMoment sun;
    sun.azimuthDeg = 150;
    sun.altitudeDeg = 40;
    const CameraPose seen = lookFromSun({}, sun);
    EXPECT_EQ(seen.headingDeg, 330);
    EXPECT_EQ(seen.pitchDeg, 40);
    // From eye to ground is away from the sun.
    const double azimuth = 150 * M_PI / 180, altitude = 40 * M_PI / 180;
    const glm::dvec3 towards{std::cos(altitude) * std::sin(azimuth), std::cos(altitude) * std::cos(azimuth),
                             std::sin(altitude)};
    EXPECT_NEAR(glm::dot(computeForward(seen), towards), -1, 1e-9);
}

TEST_F(ProjectWindow, TheMenuOfTheViewIsAboutWhatIsUnderTheCursor) {
    Project next = session().project();
    next.places.push_back({"Meadow", PlaceKind::park, {test::square({-60, -60}, 120)}});
    ASSERT_TRUE(session().change(next, QStringLiteral("place")));
    CityView& view = window->panel().view();
    view.setPose({{0, 0, 0}, 60, 0, 90});
    const QPointF middle(view.width() / 2.0, view.height() / 2.0);
    const auto pick = window->panel().navigator().pickAt(middle);
    ASSERT_TRUE(pick);
    const QStringList entries = entriesOf(*window->context().makeMenu(middle));
    EXPECT_EQ(entries.contains(QStringLiteral("Demolish")), pick->building.has_value());
    EXPECT_EQ(entries.contains(QStringLiteral("Meadow")), !pick->building.has_value());
    EXPECT_TRUE(entries.contains(QStringLiteral("Draw lot")));
}

TEST_F(ProjectWindow, TheMenuOfABuildingSelectsIt) {
    // Building 1 is the Low House: looked at from above, it is in the middle of the view.
    const Building& house = *workbench().city()->city().buildings[1];
    const Box2 box = bounds(house);
    const glm::dvec2 middle = glm::dvec2(box.low + box.high) / 2.0;
    CityView& view = window->panel().view();
    view.setPose({{middle.x, middle.y, 0}, 200, 0, 90});
    const auto menu = window->context().makeMenu({view.width() / 2.0, view.height() / 2.0});
    ASSERT_TRUE(entriesOf(*menu).contains(QStringLiteral("Demolish")));
    for (QAction* action : menu->actions())
        if (action->text() == QStringLiteral("Select")) action->trigger();
    EXPECT_EQ(window->tools().building().selected(), 1U);
    for (QAction* action : menu->actions())
        if (action->text() == QStringLiteral("Study its surroundings")) action->trigger();
    const Box2 region = bounds(workbench().document().settings().region);
    EXPECT_LT(region.low.x, box.low.x - 49);
    EXPECT_GT(region.high.y, box.high.y + 49);
}

TEST_F(ProjectWindow, TheMenuOfOneOfSeveralSelectedBuildingsDemolishesThemAll) {
    const Box2 box = bounds(*workbench().city()->city().buildings[1]);
    const glm::dvec2 middle = glm::dvec2(box.low + box.high) / 2.0;
    CityView& view = window->panel().view();
    view.setPose({{middle.x, middle.y, 0}, 200, 0, 90});
    window->tools().building().selectAll({0, 1});
    const auto menu = window->context().makeMenu({view.width() / 2.0, view.height() / 2.0});
    EXPECT_FALSE(entriesOf(*menu).contains(QStringLiteral("Demolish")));
    for (QAction* action : menu->actions())
        if (action->text() == QStringLiteral("Demolish the 2 selected")) action->trigger();
    ASSERT_TRUE(waitFor([this] { return workbench().city()->city().buildings.size() == 1; }));
    workbench().document().undoStack().undo();
    ASSERT_TRUE(waitFor([this] { return workbench().city()->city().buildings.size() == 3; }))
        << "one step of undo";
}

}  // namespace
}  // namespace noonmark
