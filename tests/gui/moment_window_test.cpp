#include <gtest/gtest.h>

#include <QLabel>
#include <QSettings>
#include <QSlider>
#include <QTemporaryDir>
#include <algorithm>
#include <array>

#include "app/window/frame/main_window.h"
#include "app/window/time/time_strip.h"
#include "app/window/view/view_panel.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using namespace std::chrono_literals;
using test::waitFor;

/// The window with the sample at 15:00 on 21 March, seen from above.
struct MomentWindow : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    MainWindow window{settings};

    void SetUp() override {
        window.resize(1000, 760);
        window.show();
        window.open({QStringLiteral("sample:grid")});
        ASSERT_TRUE(waitFor([this] { return window.workbench().city() != nullptr; }));
        window.panel().navigator().lookFromAbove();
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

// The point's neighbours have the same sun or shadow, so that a pixel beside it is as good.
bool isEven(const SunDepthMap& map, glm::dvec3 point) {
    const bool shaded = map.shades(point, 0.1);
    return std::ranges::all_of(
        std::array{glm::dvec3(2, 0, 0), glm::dvec3(-2, 0, 0), glm::dvec3(0, 2, 0), glm::dvec3(0, -2, 0)},
        [&](glm::dvec3 step) { return map.shades(point + step, 0.1) == shaded; });
}

TEST_F(MomentWindow, TheGroundIsDarkWhereSomethingHidesTheSun) {
    time().setValue(15 * 60);
    EXPECT_EQ(window.panel().time().look().span, LookSpan::moment);
    EXPECT_FALSE(window.exploration().working()) << "the moment is shown instead";
    const SunShadow& shadow = window.shadow();
    ASSERT_TRUE(waitFor([&] { return shadow.map() && shadow.map()->size == 4096; }, 30000));
    const QImage image = captured();
    int dark = 0, lit = 0, wrong = 0;
    for (double x = -200; x <= 200; x += 9)
        for (double y = -200; y <= 200; y += 9) {
            const glm::dvec3 point(x, y, 0);
            const auto pick = window.panel().navigator().pickAt(pixelAt(point));
            const QColor colour = colourAt(image, point);
            if (!pick || pick->building || !colour.isValid() || !isEven(*shadow.map(), point)) continue;
            const bool shaded = shadow.map()->shades(point, 0.1);
            ++(shaded ? dark : lit);
            wrong += (colour.lightness() < 160) != shaded;
        }
    EXPECT_GT(dark, 30);
    EXPECT_GT(lit, 30);
    EXPECT_LE(wrong, (dark + lit) / 20);
}

TEST_F(MomentWindow, TheWholePeriodAndTheNightHaveNoShadowMap) {
    time().setValue(15 * 60);
    ASSERT_TRUE(waitFor([this] { return window.shadow().map() != nullptr; }));
    time().setValue(60);
    EXPECT_EQ(window.shadow().map(), nullptr) << "at one in the morning";
    const auto* sun = window.panel().time().findChild<QLabel*>(QStringLiteral("sunText"));
    EXPECT_EQ(sun->text(), QStringLiteral("Sun below the horizon"));
    EXPECT_FALSE(window.panel().view().sun().shown());
    time().setValue(12 * 60);
    ASSERT_TRUE(waitFor([this] { return window.shadow().map() != nullptr; }));
    TimeLook period = window.panel().time().look();
    period.span = LookSpan::period;
    window.panel().time().setLook(period);
    Q_EMIT window.panel().time().lookChanged(period);
    EXPECT_EQ(window.shadow().map(), nullptr);
    ASSERT_TRUE(waitFor([this] { return window.exploration().answer() != nullptr; }, 20000));
}

}  // namespace
}  // namespace noonmark
