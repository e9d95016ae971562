#include <gtest/gtest.h>

#include <QLabel>
#include <QSettings>
#include <QSlider>
#include <QTemporaryDir>
#include <algorithm>
#include <array>

#include "app/gui/frame/main_window.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/time/sun_at_moment.h"
#include "app/gui/view/time/time_strip.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using namespace std::chrono_literals;
using test::waitFor;

/// The window with the sample at 15:00 on 21 March, seen from above; drawn by rays, or as triangles with a
/// map of the shadow.
struct MomentWindow : ::testing::TestWithParam<bool> {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    MainWindow window{settings};

    void SetUp() override {
        window.time().setClock(
            [] { return Instant(std::chrono::sys_days(2026y / std::chrono::March / 21) + 17h); });
        window.resize(1000, 760);
        window.show();
        window.open({QStringLiteral("sample:grid")});
        ASSERT_TRUE(waitFor([this] { return window.workbench().city() != nullptr; }));
        if (!GetParam()) window.panel().view().clearRays();
        window.panel().navigator().show({{-120, -120}, {120, 120}});
    }

    [[nodiscard]] bool hasMap() const { return window.shadow().map() != nullptr; }

    /// Until the finest shadow is drawn.
    [[nodiscard]] bool waitForShadow() {
        if (GetParam()) return window.panel().view().isTraced();
        return waitFor([this] { return hasMap() && window.shadow().map()->size == 4096; }, 30000);
    }

    /// Whether the city hides the moment's sun from a point of the ground.
    [[nodiscard]] bool isShaded(glm::dvec3 point) {
        const StudySettings& study = window.workbench().document().settings();
        const City& city = window.workbench().city()->city();
        const auto sun = computeSunAt(makeObserver(city, study), study.period, window.panel().time().look());
        return window.panel().navigator().scene().scene()->occluded(glm::vec3(point) + glm::vec3(0, 0, 0.1F),
                                                                    glm::vec3(sun->towards));
    }

    /// The point's neighbours have the same sun or shadow, so that a pixel beside it is as good.
    bool isEven(glm::dvec3 point) {
        const bool shaded = isShaded(point);
        return std::ranges::all_of(
            std::array{glm::dvec3(2, 0, 0), glm::dvec3(-2, 0, 0), glm::dvec3(0, 2, 0), glm::dvec3(0, -2, 0)},
            [&](glm::dvec3 step) { return isShaded(point + step) == shaded; });
    }

    [[nodiscard]] QSlider& time() {
        return *window.panel().time().findChild<QSlider*>(QStringLiteral("lookTime"));
    }

    QImage captured() {
        QImage image;
        window.panel().view().capture([&image](const QImage& made) { image = made; });
        EXPECT_TRUE(waitFor([&image] { return !image.isNull(); }, 20000));
        return image;
    }

    QPointF pixelAt(glm::dvec3 point) {
        CityView& view = window.panel().view();
        const auto pixel = pixelOf(view.pose(), view.lens(), point);
        return pixel ? QPointF(pixel->x, pixel->y) : QPointF(-1, -1);
    }

    QColor colourAt(const QImage& image, glm::dvec3 point) {
        const QPoint at = (pixelAt(point) * window.panel().view().devicePixelRatio()).toPoint();
        return image.rect().contains(at) ? image.pixelColor(at) : QColor();
    }
};

TEST_P(MomentWindow, TheGroundIsDarkWhereSomethingHidesTheSun) {
    time().setValue(15 * 60);
    EXPECT_EQ(window.panel().time().look().span, ShownSpan::moment);
    EXPECT_FALSE(window.exploration().working()) << "the moment is shown instead";
    ASSERT_TRUE(waitForShadow());
    captured();  // frames lag behind the scene
    const QImage image = captured();
    int dark = 0, lit = 0, wrong = 0;
    for (double x = -110; x <= 110; x += 4)
        for (double y = -110; y <= 110; y += 4) {
            const glm::dvec3 point(x, y, 0);
            const auto pick = window.panel().navigator().pickAt(pixelAt(point));
            const QColor colour = colourAt(image, point);
            if (!pick || pick->building || !colour.isValid() || !isEven(point)) continue;
            const bool shaded = isShaded(point);
            ++(shaded ? dark : lit);
            wrong += (colour.lightness() < 195) != shaded;
        }
    EXPECT_GT(dark, 30);
    EXPECT_GT(lit, 30);
    EXPECT_LE(wrong, (dark + lit) / 20);
}

TEST_P(MomentWindow, TheWholePeriodAndTheNightHaveNoShadow) {
    CityView& view = window.panel().view();
    time().setValue(15 * 60);
    ASSERT_TRUE(waitForShadow());
    EXPECT_EQ(view.sun().shown(), !GetParam()) << "rays need no map";
    time().setValue(60);
    EXPECT_FALSE(hasMap()) << "at one in the morning";
    const auto* sun = window.panel().time().findChild<QLabel*>(QStringLiteral("sunText"));
    EXPECT_EQ(sun->text(), QStringLiteral("Sun below the horizon"));
    EXPECT_FALSE(view.sun().shown());
    time().setValue(12 * 60);
    ASSERT_TRUE(waitForShadow());
    ShownTime period = window.panel().time().look();
    period.span = ShownSpan::period;
    window.panel().time().setLook(period);
    Q_EMIT window.panel().time().lookChanged(period);
    EXPECT_FALSE(hasMap());
    ASSERT_TRUE(waitFor([this] { return window.exploration().answer() != nullptr; }, 20000));
}

// Where the camera leaves the ground whose shadow is drawn, a coarse shadow of all that is seen comes at
// once.
TEST_P(MomentWindow, GroundThatComesIntoSightHasShadow) {
    if (GetParam()) return;  // rays have no map
    window.panel().navigator().show({{-20, -20}, {20, 20}});
    time().setValue(15 * 60);
    ASSERT_TRUE(waitForShadow());
    std::vector<int> sizes;
    QObject::connect(&window.shadow(), &SunShadow::changed, &window.shadow(),
                     [&] { sizes.push_back(window.shadow().map()->size); });
    window.panel().navigator().show({{-400, -400}, {400, 400}});
    ASSERT_TRUE(waitFor([&] { return !sizes.empty(); }));
    EXPECT_LT(sizes.front(), 4096);
    ASSERT_TRUE(waitFor([&] { return sizes.back() == 4096; }));
}

INSTANTIATE_TEST_SUITE_P(ByRays, MomentWindow, ::testing::Values(true));
INSTANTIATE_TEST_SUITE_P(AsTriangles, MomentWindow, ::testing::Values(false));

}  // namespace
}  // namespace noonmark
