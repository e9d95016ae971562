#include "render/view/section_box.h"

#include <QDialog>
#include <QMouseEvent>

#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/session/project/view_state.h"
#include "app/gui/view/panel/view_tools.h"
#include "render/view/camera_control.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::ProjectWindow;
using test::waitFor;

const SectionBox box{{0, 0, 0}, {10, 20, 30}};

TEST(SectionBox, ASideStopsOneMetreBeforeTheOpposite) {
    EXPECT_EQ(moveSide(box, {0, true}, 4), (SectionBox{{0, 0, 0}, {4, 20, 30}}));
    EXPECT_EQ(moveSide(box, {0, true}, -8), (SectionBox{{0, 0, 0}, {1, 20, 30}}));
    EXPECT_EQ(moveSide(box, {2, false}, 100), (SectionBox{{0, 0, 29}, {10, 20, 30}}));
    EXPECT_EQ(centreOf(box, {1, true}), glm::dvec3(5, 20, 15));
}

TEST(SectionBox, ARayIsInsideBetweenTwoDistances) {
    // From 100 m above the middle straight down: enters at z = 30, leaves at z = 0; a centimetre is shared.
    const auto down = findSpan(box, {{5, 10, 100}, {0, 0, -1}});
    ASSERT_TRUE(down);
    EXPECT_NEAR(down->fromM, 70, 0.011);
    EXPECT_NEAR(down->toM, 100, 0.011);
    EXPECT_FALSE(findSpan(box, {{50, 10, 100}, {0, 0, -1}}));
    EXPECT_FALSE(findSpan(box, {{5, 10, 100}, {0, 0, 1}})) << "behind";
}

TEST(SectionBox, ReadsOnlyBoxesThatCanBeShown) {
    EXPECT_EQ(parseViewState({{"section", "[0,0,0,10,20,30]"}}).section, box);
    EXPECT_EQ(parseViewState({{"section", "[0,0,0,-5,20,30]"}}).section,
              (SectionBox{{0, 0, 0}, {1, 20, 30}}));
    for (const char* text : {"", "[0,0,0,10,20]", "[0,0,0,1e30,20,30]", "{}", "[0,0,0,null,1,1]"})
        EXPECT_FALSE(parseViewState({{"section", text}}).section) << text;
    ViewState state;
    state.section = box;
    EXPECT_EQ(parseViewState(textsOf(state)).section, box);
}

TEST(CameraControl, OrbitingOutOfAnElevationTurnsAboutTheGroundBelowTheMiddle) {
    const ViewLens lens{40, 1200, 800};
    CameraPose pose{{10, 20, 110}, 500, 0, 0};
    pose.projection = Projection::parallel;
    const glm::dvec3 pivot{10, 20, 0};
    const ViewBounds city{{{-1500, -900}, {1200, 1100}}, 300, 0};
    const auto before = pixelOf(pose, lens, pivot);
    const auto flat = [](glm::dvec2) { return 0.0; };
    for (int i = 0; i < 60; ++i)
        pose = keepAboveGround(orbit(pose, pivot, {2, 3}, lens), computeLimits(city), flat);
    EXPECT_GT(pose.pitchDeg, 25);
    const auto after = pixelOf(pose, lens, pivot);
    ASSERT_TRUE(before && after);
    EXPECT_NEAR(after->x, before->x, 1e-6);
    EXPECT_NEAR(after->y, before->y, 1e-6);
}

struct SectionWindow : ProjectWindow {
    SectionTool& tool() { return window->panel().section(); }
    CityView& view() { return window->panel().view(); }
    QColor colourAt(const glm::dvec3& point) {
        QImage image;
        view().capture([&image](const QImage& made) { image = made; });
        EXPECT_TRUE(waitFor([&image] { return !image.isNull(); }));
        const auto pixel = pixelOf(view().pose(), view().lens(), point);
        const double ratio = view().devicePixelRatio();
        return image.pixelColor(int(pixel->x * ratio), int(pixel->y * ratio));
    }
    bool becomes(const glm::dvec3& point, const std::function<bool(QColor)>& holds) {
        return waitFor([&] { return holds(colourAt(point)); }, 10000);  // frames lag behind the scene
    }
};

TEST_F(SectionWindow, CutsBuildingsAndPicksWhatIsLeft) {
    const Building& building = *workbench().city()->city().buildings.front();
    const glm::dvec2 middle(findMiddle(building));
    const double topM = double(noonmark::topM(building));
    window->mode().setMode(ViewMode::analysis);
    view().setPose({{middle.x, middle.y, 0}, 300, 0, 90});
    const QPointF centre(view().width() / 2.0, view().height() / 2.0);
    const auto roof = window->panel().navigator().pickAt(centre);
    ASSERT_TRUE(roof && roof->building);
    EXPECT_NEAR(roof->position.z, topM, 0.01);
    window->camera().sectionBox()->trigger();
    ASSERT_TRUE(tool().box());
    tool().set(moveSide(*tool().box(), {2, true}, topM / 2));
    // Through the cut the inside is drawn in the colour of what was cut, red 0.36 x 255 = 92.
    EXPECT_TRUE(becomes({middle.x, middle.y, topM / 2}, [](QColor c) { return std::abs(c.red() - 92) < 4; }));
    const auto cut = window->panel().navigator().pickAt(centre);
    ASSERT_TRUE(cut && cut->building) << "a cut building can still be picked";
    EXPECT_NEAR(cut->position.z, topM / 2, 0.02) << "in the cut";
    window->camera().sectionBox()->trigger();
    EXPECT_FALSE(tool().box());
    EXPECT_TRUE(becomes({middle.x, middle.y, topM}, [](QColor c) { return c.red() > 150; }));
}

TEST_F(SectionWindow, IsMovedByHandlesAndNumbersAndSaved) {
    window->camera().sectionBox()->trigger();
    EXPECT_TRUE(window->camera().sectionBox()->isChecked());
    view().setPose({{0, 0, 0}, 900, 0, 90});
    const SectionBox start = *tool().box();
    const auto east = pixelOf(view().pose(), view().lens(), centreOf(start, {0, true}));
    ASSERT_TRUE(east);
    // From above a pixel is the same length everywhere at one height: the handle's own.
    const auto further =
        pixelOf(view().pose(), view().lens(), centreOf(start, {0, true}) - glm::dvec3(25, 0, 0));
    ASSERT_TRUE(tool().grab({east->x, east->y}));
    tool().dragTo({further->x, further->y});
    tool().drop();
    EXPECT_NEAR(tool().box()->highM.x, start.highM.x - 25, 1e-6);
    auto* dialog = window->findChild<QDialog*>(QStringLiteral("sectionDialog"));
    ASSERT_TRUE(dialog && dialog->isVisible());
    auto* field = dialog->findChild<LengthField*>(QStringLiteral("section1"));
    EXPECT_NEAR(field->value(), start.highM.x - 25, 0.06);
    field->setValue(12);
    EXPECT_EQ(tool().box()->highM.x, 12);
    const SectionBox saved = *tool().box();
    build();  // so that there is something to save
    save();
    open(file);
    EXPECT_EQ(tool().box(), saved);
    dialog->findChild<QPushButton*>(QStringLiteral("sectionRemove"))->click();
    EXPECT_FALSE(tool().box());
    EXPECT_FALSE(dialog->isVisible());
}

TEST_F(SectionWindow, ARightClickThatEndsAPolygonOpensNoMenu) {
    int menus = 0;
    QObject::connect(&window->panel(), &ViewPanel::menuRequested, &window->panel(), [&menus] { ++menus; });
    PolygonTool& lot = window->panel().lotTool();
    lot.begin();
    for (const glm::dvec2 point : {glm::dvec2(0, 0), {30, 0}, {30, 30}})
        lot.addPoint(glm::dvec3(point, 0), false);
    Q_EMIT window->panel().navigator().rightClicked({10, 10});
    EXPECT_FALSE(lot.active());
    EXPECT_EQ(menus, 0);
}

}  // namespace
}  // namespace noonmark
