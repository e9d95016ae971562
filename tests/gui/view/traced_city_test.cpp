#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "app/gui/view/panel/view_panel.h"
#include "render/view/scene_picker.h"
#include "render/view/traced_city.h"
#include "tests/gui/small_city.h"
#include "tests/gui/small_open_city.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

/// The same view drawn by rays and drawn as triangles.
struct TracedCityView : ::testing::Test {
    ViewPanel panel;
    std::shared_ptr<const OpenCity> city = test::smallOpenCity();

    void SetUp() override {
        if (!drawsInSoftware()) GTEST_SKIP() << "rays draw only where the processor does";
        panel.resize(700, 600);
        panel.show();
        panel.showCity(city);
        panel.navigator().showSlanting({{-120, -80}, {100, 80}});
    }

    QImage captured() {
        for (int i = 0; i < 2; ++i) take();  // frames lag behind the scene
        return take();
    }

    QImage take() {
        QImage image;
        panel.view().capture([&image](const QImage& made) { image = made; });
        EXPECT_TRUE(waitFor([&image] { return !image.isNull(); }));
        return image;
    }

    /// The share of pixels whose grey differs by more than `maximum`.
    static double differing(const QImage& a, const QImage& b, int maximum) {
        int count = 0;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                count += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > maximum ? 1 : 0;
        return double(count) / (a.width() * a.height());
    }

    // Edges are a line of pixels in both, but not always the same ones.
    void expectSame(const char* what) {
        ASSERT_TRUE(panel.view().isTraced()) << what;
        const QImage traced = captured();
        panel.view().clearRays();
        ASSERT_FALSE(panel.view().isTraced()) << what;
        const QImage triangles = captured();
        panel.view().setRays(*city->picker.scene(), city->city().buildings);
        ASSERT_EQ(traced.size(), triangles.size());
        EXPECT_LT(differing(traced, triangles, 12), 0.03) << what;
    }
};

// Of one colour: software OpenGL blurs between the cells of a picture, rays do not.
GroundPicture brownGround() {
    GroundPicture picture;
    picture.grid = {-100, -80, 20, 10, 8};
    picture.pixels.assign(picture.grid.size(), {120, 40, 20, 200});
    return picture;
}

TEST_F(TracedCityView, LooksLikeTriangles) { expectSame("plain"); }

TEST_F(TracedCityView, IsCoarseOnlyWhileTheCameraMoves) {
    CameraPose pose = panel.view().pose();
    pose.headingDeg += 10;
    panel.view().setPose(pose);
    EXPECT_TRUE(panel.view().isMoving());
    ASSERT_TRUE(waitFor([this] { return !panel.view().isMoving(); }));
    const QImage resting = captured();
    panel.view().setPose(pose);
    EXPECT_FALSE(panel.view().isMoving()) << "it is where it was";
    pose.headingDeg += 10;
    panel.view().setPose(pose);
    pose.headingDeg -= 10;
    panel.view().setPose(pose);
    EXPECT_LT(differing(captured(), resting, 12), 0.001) << "pictures are never coarse";
}

TEST_F(TracedCityView, ShowsPicturesOnGroundAndRoofsLikeTriangles) {
    const QImage plain = captured();
    panel.view().showPicture(brownGround());
    panel.view().showRoofPicture(brownGround());
    EXPECT_GT(differing(plain, captured(), 12), 0.05);
    expectSame("pictures");
}

TEST_F(TracedCityView, IsCutBySectionsLikeTriangles) {
    const QImage plain = captured();
    panel.view().showSection(SectionBox{{-90, -70, -1}, {80, 60, 25}});
    EXPECT_GT(differing(plain, captured(), 12), 0.05);
    expectSame("section");
}

TEST_F(TracedCityView, LeavesOutWhatAnEditRemoves) {
    const QImage plain = captured();
    ArrayDifference changes;
    changes.removed = {0};
    panel.view().showChanges(changes);
    EXPECT_TRUE(panel.view().isTraced());
    const QImage without = captured();
    EXPECT_GT(differing(plain, without, 12), 0.01);
    panel.view().showChanges({});
    EXPECT_LT(differing(plain, captured(), 12), 0.001);
}

TEST_F(TracedCityView, ShowsTheSunOfAMoment) {
    const QImage plain = captured();
    panel.view().showTracedSun(glm::normalize(glm::dvec3(1, -1, 1)));
    EXPECT_GT(differing(plain, captured(), 12), 0.05);
    panel.view().showTracedSun(std::nullopt);
    EXPECT_LT(differing(plain, captured(), 12), 0.001);
}

TEST_F(TracedCityView, FollowsTheCamera) {
    const QImage before = captured();
    CameraPose pose = panel.view().pose();
    pose.headingDeg += 40;
    panel.view().setPose(pose);
    EXPECT_GT(differing(before, captured(), 12), 0.05);
    expectSame("turned");
}

// A comparison that ends clears a city whose edges were hidden while the camera moved.
TEST(DrawnCity, ManyEdgesThatAreClearedAreNotHiddenAgain) {
    CityView view;
    auto arrays = std::make_shared<CityArrays>(makeArrays(test::smallCity()));
    arrays->edges.resize(400'000, arrays->edges.front());
    view.showCity(arrays);
    view.other().showCity(arrays);
    EXPECT_TRUE(view.other().hideEdges());
    view.other().clear();
    EXPECT_FALSE(view.other().hideEdges());
    view.setPose(view.pose());
}

// Without faces only edges are drawn, as lines.
TEST_F(TracedCityView, EndsWithoutFaces) {
    panel.view().showFaces(false);
    EXPECT_FALSE(panel.view().isTraced());
    panel.view().showFaces(true);
    EXPECT_TRUE(panel.view().isTraced());
}

// Of a view without a size: 0 divided by 0.
TEST(ScenePicker, ARayThatIsNoNumberHitsNothing) {
    const City city = test::smallCity();
    const ScenePicker picker(city, RayScene::over(city).value());
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(picker.pick({{0, 0, 100}, {none, none, none}}));
    EXPECT_FALSE(picker.pick({{0, 0, 100}, {none, 0, -1}}, {{-50, -50, 0}, {50, 50, 90}}));
    EXPECT_TRUE(picker.pick({{0, -40, 100}, {0, 0, -1}})) << "South House";
}

}  // namespace
}  // namespace noonmark
