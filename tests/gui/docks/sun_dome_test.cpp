#include "app/gui/docks/point/dome_display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <glm/geometric.hpp>

#include "app/gui/view/time/time_strip.h"
#include "render/view/camera_control.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using namespace std::chrono_literals;
using std::chrono::June;
using std::chrono::March;
using test::ProjectWindow;
using test::waitFor;
using testing::Contains;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

using Stroke = DomeMarks::Stroke;

const ViewLens wide{40, 1200, 800};
const CameraPose slantingPose{{100, 50, 7}, 1000, 20, 45};
const SunPathQuestion inNewYorkState{
    .observer = {.place = {-73.98, 40.76}}, .zone = "America/New_York", .clockOffset = -4h};

std::vector<std::string> namesOf(const std::vector<NameLabels::Label>& labels) {
    std::vector<std::string> names;
    for (const auto& label : labels) names.push_back(label.name.toStdString());
    return names;
}

glm::dvec3 anchorOf(const DomeMarks::Net& net, const char* name) {
    for (const auto& label : net.labels)
        if (label.name == QLatin1String(name)) return label.at;
    ADD_FAILURE() << name;
    return {};
}

TEST(SunDome, FitsTheViewAndStaysWhileTheCameraTurns) {
    const DomePlace place = placeDome(slantingPose, wide, 7, std::nullopt);
    EXPECT_NEAR(place.centre.x, 100, 1e-9);
    EXPECT_NEAR(place.centre.z, 7, 0.01 * place.radiusM) << "on the ground";
    CameraPose turned = slantingPose;
    for (int i = 0; i < 20; ++i) {
        turned = orbit(turned, {60, 3}, wide);
        EXPECT_EQ(placeDome(turned, wide, 7, std::nullopt), place);
        for (double azimuth = 0; azimuth < 6.28; azimuth += 0.1) {
            const glm::dvec3 towards(std::sin(azimuth), std::cos(azimuth), 0);
            const auto pixel = pixelOf(turned, wide, place.centre + place.radiusM * towards);
            ASSERT_TRUE(pixel);
            EXPECT_GE(pixel->x, 0);
            EXPECT_GE(pixel->y, 0);
            EXPECT_LE(pixel->x, wide.widthPx);
            EXPECT_LE(pixel->y, wide.heightPx);
        }
    }
    EXPECT_LT(placeDome(slantingPose, {40, 400, 800}, 7, std::nullopt).radiusM, 0.6 * place.radiusM)
        << "narrow";
    EXPECT_EQ(placeDome(slantingPose, wide, 7, glm::dvec3(3, 4, 30)).centre.x, 3) << "around the pin";
}

TEST(SunDome, DriftsWithTheCamera) {
    const DomePlace place{{0, 0, 0}, 100};
    EXPECT_EQ(compareDomes(place, {{1, 0, 0}, 101}), DomeMismatch::none);
    EXPECT_EQ(compareDomes(place, {{20, 0, 0}, 100}), DomeMismatch::small);
    EXPECT_EQ(compareDomes(place, {{0, 0, 0}, 120}), DomeMismatch::small);
    EXPECT_EQ(compareDomes(place, {{0, 90, 0}, 100}), DomeMismatch::large);
    EXPECT_EQ(compareDomes(place, {{0, 0, 0}, 40}), DomeMismatch::large);
}

TEST(SunDome, NamesQuartersMonthsAndHours) {
    const DomePlace place{{10, 20, 5}, 100};
    const DomeMarks::Net net = drawDome(computeSunPaths(inNewYorkState).value(), glm::dmat3(1), place);
    EXPECT_THAT(namesOf(net.labels), Contains("12:00"));
    EXPECT_THAT(namesOf(net.labels), Not(Contains("0:00")));
    EXPECT_GT(anchorOf(net, "N").y, 20 + 100);
    EXPECT_GT(anchorOf(net, "E").x, 10 + 100);
    EXPECT_GT(anchorOf(net, "Mar").x, 10 + 90) << "where the sun rises";
    EXPECT_LT(anchorOf(net, "Sep").x, 10 - 90) << "where it sets";
    EXPECT_LT(anchorOf(net, "Dec").y, anchorOf(net, "Sep").y) << "farther south in winter";
    EXPECT_THAT(net.lines[std::size_t(Stroke::mainMonth)], SizeIs(4));
    EXPECT_THAT(net.lines[std::size_t(Stroke::month)], SizeIs(8));
    for (const auto& lines : net.lines)
        for (const GroundLine& line : lines)
            for (const glm::vec3 point : line.points) {
                EXPECT_GT(point.z, 5 - 1);
                EXPECT_NEAR(glm::distance(glm::dvec3(point), place.centre), 100, 7) << "ticks are 12 long";
            }
}

TEST(SunDome, TheNightHasNoSun) {
    const DomePlace place{{10, 20, 5}, 100};
    const auto path = computeSunPath(inNewYorkState, 2026y / March / 21).value();
    EXPECT_FALSE(drawDomeSun(path, {0, 0.8, -0.6}, place).at);
    const DomeMarks::Sun sun = drawDomeSun(path, {0, -0.6, 0.8}, place);
    ASSERT_TRUE(sun.at);
    EXPECT_NEAR(sun.at->y, 20 - 60, 1e-9);
    EXPECT_EQ(sun.lines.back().points.front(), glm::vec3(10, 20, 5));
}

struct DomeWindow : ProjectWindow {
    DomeMarks& marks() { return window->panel().view().dome(); }
    CityView& view() { return window->panel().view(); }
    [[nodiscard]] DomePlace place() const { return window->dome().place().value_or(DomePlace{}); }
    void chooseMoment(std::chrono::minutes at) {
        window->panel().time().choose({ShownSpan::moment, 2026y / June / 21, at});
    }
    QImage captured() {
        QImage image;
        view().capture([&image](const QImage& made) { image = made; });
        EXPECT_TRUE(waitFor([&image] { return !image.isNull(); }, 20000));
        return image;
    }
    bool isOrangeAt(glm::dvec3 point) {
        const auto pixel = pixelOf(view().pose(), view().lens(), point);
        if (!pixel) return false;
        const double ratio = view().devicePixelRatio();
        const QColor colour =
            captured().pixelColor(int(pixel->x * ratio), int((pixel->y - DomeMarks::sunPx / 4) * ratio));
        return colour.red() > 150 && colour.red() > 2 * colour.blue();
    }
};

TEST_F(DomeWindow, TheSwitchShowsAndHidesTheDomeAndIsRemembered) {
    EXPECT_FALSE(window->dome().place());
    EXPECT_THAT(marks().net().labels, IsEmpty());
    window->dome().action()->trigger();
    ASSERT_TRUE(window->dome().place());
    EXPECT_THAT(namesOf(marks().net().labels), Contains("Jun"));
    EXPECT_THAT(marks().named(), Not(IsEmpty()));
    EXPECT_THAT(marks().sun().lines, Not(IsEmpty())) << "the window begins with a moment of daylight";
    makeWindow();
    EXPECT_TRUE(window->dome().action()->isChecked());
    open(file);
    EXPECT_TRUE(window->dome().place());
    window->dome().action()->trigger();
    EXPECT_FALSE(window->dome().place());
    EXPECT_THAT(marks().net().labels, IsEmpty());
    EXPECT_THAT(marks().named(), IsEmpty());
}

TEST_F(DomeWindow, TheSunFollowsTheTimeStrip) {
    window->dome().action()->trigger();
    chooseMoment(16h);
    const auto first = marks().sun().at;
    ASSERT_TRUE(first);
    EXPECT_NEAR(glm::distance(*first, place().centre), place().radiusM, 0.01);
    EXPECT_TRUE(waitFor([&] { return isOrangeAt(*marks().sun().at); }, 20000));
    chooseMoment(18h);
    ASSERT_TRUE(marks().sun().at);
    EXPECT_GT(glm::distance(*first, *marks().sun().at), 0.3 * place().radiusM);
    const auto june = marks().sun().lines.front().points;
    window->panel().time().choose({ShownSpan::moment, 2026y / std::chrono::December / 21, 18h});
    EXPECT_NE(marks().sun().lines.front().points, june);
    ShownTime period = window->panel().time().look();
    period.span = ShownSpan::period;
    window->panel().time().choose(period);
    EXPECT_FALSE(marks().sun().at);
    EXPECT_THAT(marks().sun().lines, IsEmpty());
}

TEST_F(DomeWindow, FollowsTheCameraButNotItsTurns) {
    window->panel().navigator().go({{0, 0, 0}, 500, 0, 45});
    window->dome().action()->trigger();
    const DomePlace before = place();
    CameraPose pose = view().pose();
    pose.headingDeg = 77;
    pose.pitchDeg = 30;
    window->panel().navigator().go(pose);
    EXPECT_EQ(place(), before);
    pose.target.x += 0.3 * before.radiusM;
    window->panel().navigator().go(pose);
    EXPECT_EQ(place(), before) << "until the camera rests";
    EXPECT_TRUE(waitFor([&] { return place().centre.x > before.centre.x; }, 5000));
    pose.distanceM = 100;
    window->panel().navigator().go(pose);
    EXPECT_LT(place().radiusM, 0.3 * before.radiusM) << "at once, since it left the view";
}

TEST_F(DomeWindow, StandsAroundThePinOfTheDockPoint) {
    window->panel().navigator().go({{0, 0, 0}, 500, 0, 60});
    window->dome().action()->trigger();
    window->points().setVisible(true);
    window->points().inspect({{-20, 10, 0}, std::nullopt, {0, 0, 1}});
    ASSERT_TRUE(view().overlay().pin());
    EXPECT_TRUE(waitFor([&] { return place().centre.x == -20 && place().centre.y == 10; }, 5000));
    window->points().forget();
    EXPECT_TRUE(waitFor([&] { return place().centre.x == view().pose().target.x; }, 5000));
}

}  // namespace
}  // namespace noonmark
