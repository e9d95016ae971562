#include "render/scene/city_bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "app/gui/view/panel/view_panel.h"
#include "tests/gui/small_open_city.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

/// The view of the small city, checked by pixel.
struct OverlayTest : ::testing::Test {
    ViewPanel panel;
    std::shared_ptr<const OpenCity> city = test::smallOpenCity();

    void SetUp() override {
        panel.resize(700, 600);
        panel.show();
        panel.showCity(city);
        panel.navigator().showSlanting({{-120, -80}, {100, 80}});
    }

    [[nodiscard]] City only(std::size_t building) const {
        City some;
        some.buildings.push_back(city->city().buildings[building]);
        return some;
    }

    QImage captured() {
        QImage image;
        panel.view().capture([&image](const QImage& made) { image = made; });
        EXPECT_TRUE(waitFor([&image] { return !image.isNull(); }));
        return image;
    }

    QColor colourAt(glm::dvec3 point) {
        const auto pixel = pixelOf(panel.view().pose(), panel.view().lens(), point);
        const double ratio = panel.view().devicePixelRatio();
        return captured().pixelColor(int(pixel->x * ratio), int(pixel->y * ratio));
    }

    // The first frames may come before the city.
    QColor settledColourAt(glm::dvec3 point) {
        QColor colour = colourAt(point);
        for (int same = 0; same < 5; ++same) {
            const QColor next = colourAt(point);
            if (next != colour) same = 0;
            colour = next;
        }
        return colour;
    }

    // Frames lag behind the scene, so this waits.
    bool becomes(glm::dvec3 point, const std::function<bool(QColor)>& holds) {
        return waitFor([&] { return holds(colourAt(point)); }, 20000);
    }

    int handlePixels() {
        const QImage image = captured();
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QColor colour = image.pixelColor(x, y);
                count += colour.red() > 90 && colour.red() > 2 * colour.green() &&
                         colour.blue() > 2 * colour.green();
            }
        return count;
    }
};

const glm::dvec3 southFront{0, -60, 30};

bool isGreen(QColor c) { return c.green() > c.red() + 40; }
bool isBlue(QColor c) { return c.blue() > c.red() + 40; }
bool isPlain(QColor c) { return std::abs(c.red() - c.blue()) < 30; }

TEST_F(OverlayTest, TintsComeAndGo) {
    OverlayBodies& overlay = panel.view().overlay();
    EXPECT_TRUE(becomes(southFront, isPlain));
    overlay.show(OverlayBodies::Tint::selected, only(0));
    EXPECT_TRUE(becomes(southFront, isBlue));
    overlay.show(OverlayBodies::Tint::selected, {});
    EXPECT_TRUE(becomes(southFront, isPlain));
    overlay.show(OverlayBodies::Tint::proposed, only(0));
    EXPECT_TRUE(becomes(southFront, isGreen));
    overlay.show(OverlayBodies::Tint::proposed, {});
    EXPECT_TRUE(becomes(southFront, isPlain));
}

// Behind the South House; where nothing stands before it, the line is red.
TEST_F(OverlayTest, LinesAreFaintWhereABuildingHidesThem) {
    panel.view().showLines({GroundLine{{{-110, -10, 0.3F}, {110, -10, 0.3F}}, false}});
    const auto redness = [](QColor c) { return c.red() - c.green(); };
    EXPECT_TRUE(becomes({45, -10, 0.3}, [&](QColor c) { return redness(c) > 100; }));
    int hidden = 0;
    EXPECT_TRUE(becomes({0, -10, 0.3}, [&](QColor c) {
        hidden = redness(c);
        return hidden > 15 && hidden < 85;
    })) << hidden;
}

TEST_F(OverlayTest, ABuildingIsLeftOutAndComesBack) {
    const glm::dvec3 roofPoint{0, -40, 60};
    const QColor roof = settledColourAt(roofPoint);
    ArrayDifference change;
    change.removed = {0};
    panel.view().showChanges(change);
    // The ground is visible in its place, darker than a roof.
    EXPECT_TRUE(becomes(roofPoint, [&](QColor c) { return c.lightness() < roof.lightness() - 8; }))
        << roof.lightness() << " " << colourAt(roofPoint).lightness();
    change.added = only(0);
    panel.view().showChanges(change);
    EXPECT_TRUE(becomes(roofPoint, [&](QColor c) { return c == roof; }));
    panel.view().showChanges({});
    EXPECT_TRUE(becomes(roofPoint, [&](QColor c) { return c == roof; }));
}

TEST_F(OverlayTest, AnEditLeavesTheCameraWhereItIs) {
    const CameraPose pose = panel.view().pose();
    auto edited = std::make_shared<OpenCity>(*city);
    edited->loaded.read.city.buildings.pop_back();
    panel.showCity(edited);
    EXPECT_EQ(panel.view().pose(), pose);
    EXPECT_EQ(panel.view().arrays(), city->arrays);
}

TEST_F(OverlayTest, TheHandleKeepsItsSizeInPixels) {
    panel.view().overlay().showHandle(glm::dvec3(0, -40, 60));
    ASSERT_TRUE(waitFor([this] { return handlePixels() > 100; }, 20000));
    const int near = handlePixels();
    CameraPose pose = panel.view().pose();
    pose.distanceM *= 3;
    panel.view().setPose(pose);
    int far = 0;
    EXPECT_TRUE(waitFor(
        [&] {
            far = handlePixels();
            return std::abs(far - near) < 0.2 * near;
        },
        20000))
        << near << " pixels near by, " << far << " far away";
    panel.view().overlay().showHandle(std::nullopt);
    EXPECT_TRUE(waitFor([this] { return handlePixels() == 0; }, 20000));
}

}  // namespace
}  // namespace noonmark
