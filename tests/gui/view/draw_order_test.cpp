#include <gtest/gtest.h>

#include "app/gui/view/panel/ground_layers.h"
#include "app/gui/view/panel/view_panel.h"
#include "tests/gui/small_open_city.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

/// Several cities opened in turn in one view, checked by pixel: drawn by rays and drawn as triangles.
struct DrawOrder : ::testing::TestWithParam<bool> {
    ViewPanel panel;

    void SetUp() override {
        panel.resize(700, 600);
        panel.show();
    }

    void show() {
        panel.showCity(test::smallOpenCity());
        if (!GetParam()) panel.view().clearRays();
        panel.navigator().showSlanting({{-120, -80}, {100, 80}});
    }

    QImage captured() {
        QImage image;
        panel.view().capture([&image](const QImage& made) { image = made; });
        EXPECT_TRUE(waitFor([&image] { return !image.isNull(); }));
        return image;
    }

    QRect around(glm::dvec3 point, int border) {
        const auto pixel = pixelOf(panel.view().pose(), panel.view().lens(), point);
        const double ratio = panel.view().devicePixelRatio();
        const QPoint middle(int(pixel->x * ratio), int(pixel->y * ratio));
        return {middle - QPoint(border, border), middle + QPoint(border, border)};
    }

    /// The darkest and the lightest grey within a few pixels of a point.
    std::pair<int, int> greysAt(const QImage& image, glm::dvec3 point) {
        std::pair<int, int> greys{255, 0};
        const QRect near = around(point, 4);
        for (int y = near.top(); y <= near.bottom(); ++y)
            for (int x = near.left(); x <= near.right(); ++x) {
                const int grey = qGray(image.pixel(x, y));
                greys = {std::min(greys.first, grey), std::max(greys.second, grey)};
            }
        return greys;
    }

    // Frames lag behind the scene, so this waits.
    bool edgeIsSeen(glm::dvec3 point) {
        return waitFor(
            [&] {
                const auto [dark, light] = greysAt(captured(), point);
                return light - dark > 25;
            },
            5000);
    }
};

// The roof's front edge borders a face above and a face below: an edge drawn before the faces would be hidden
// there.
TEST_P(DrawOrder, EdgesAreSeenInFrontOfTheirFacesInEveryCityThatIsOpened) {
    for (int city = 1; city <= 8; ++city) {
        show();
        EXPECT_TRUE(edgeIsSeen({0, -60, 60})) << "city " << city;
    }
}

// Far from a low eye the ground lies outside of its pictures, where the filter of a texture must not run.
TEST_P(DrawOrder, ALowViewFromNearByIsDrawnToTheHorizon) {
    show();
    for (const double pitchDeg : {35.0, 20.0, 10.0, 3.0}) {
        panel.view().setPose(
            {.target = {0, -60, 1.5}, .distanceM = 80, .headingDeg = 334, .pitchDeg = pitchDeg});
        EXPECT_FALSE(captured().isNull()) << pitchDeg;
    }
}

// What is drawn must be visible through buildings, faintly; the region's outline is not.
TEST_P(DrawOrder, LinesAreSeenThroughBuildingsAndTheRegionIsNotInEveryCityThatIsOpened) {
    const auto isRedAt = [this](const QImage& image, glm::dvec3 point) {
        const QRect near = around(point, 3);
        for (int y = near.top(); y <= near.bottom(); ++y)
            for (int x = near.left(); x <= near.right(); ++x) {
                const QColor colour = image.pixelColor(x, y);
                if (colour.red() > colour.green() + 25 && colour.red() > colour.blue() + 25) return true;
            }
        return false;
    };
    const glm::dvec3 behind{0, -40, 0}, open{-55, -40, 0};  // the southern house, and beside it
    const Region region{"line", {test::square({-60, -40}, 120)}};
    for (int city = 1; city <= 8; ++city) {
        if (city == 1) panel.showRegion(region);  // a project states its region before its city is there
        show();
        panel.showRegion(region);
        EXPECT_TRUE(waitFor([&] { return isRedAt(captured(), open); })) << "city " << city;
        EXPECT_FALSE(isRedAt(captured(), behind)) << "city " << city;
        panel.view().showLines(makeGroundLines(region, test::smallOpenCity()->city()));
        EXPECT_TRUE(waitFor([&] { return isRedAt(captured(), behind); })) << "city " << city;
    }
}

INSTANTIATE_TEST_SUITE_P(ByRays, DrawOrder, ::testing::Values(true));
INSTANTIATE_TEST_SUITE_P(AsTriangles, DrawOrder, ::testing::Values(false));

}  // namespace
}  // namespace noonmark
