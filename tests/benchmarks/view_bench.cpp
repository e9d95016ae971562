// Frames per second of the view while the camera turns about the city and while the sun moves, and the view
// at rest as pictures, so that two versions can be compared by pixel.
//
// Processor time is more reliable than frames per second where other programs run.
//
//     view_bench [FILE, number of buildings or sample] [seconds for each] [folder for the pictures at rest]
//                [number of trees]
//
// NOONMARK_TRIANGLES=1 draws triangles where the processor draws, as a graphics card does.
//
// With trees: the view plain without them, in leaf and bare, and in leaf in the sun.
//
// Needs a display: xvfb-run -a draws in software.
#include <fmt/format.h>

#include <QElapsedTimer>
#include <QGuiApplication>
#include <Qt3DCore/QEntity>
#include <Qt3DLogic/QFrameAction>
#include <Qt3DRender/QCamera>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <glm/trigonometric.hpp>
#include <numeric>

#include "core/engines/depths/sun_depth_map.h"
#include "render/view/camera_control.h"
#include "render/view/city_view.h"
#include "tests/benchmarks/bench_scene.h"
#include "tests/benchmarks/planted_trees.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

constexpr QSize windowSize{1200, 800};

City namedCity(const std::string& name) {
    return name == "sample" ? makeCentralParkSouthSample() : cityFrom(name);
}

glm::dvec3 towardsSun(double hour) {
    const double azimuth = glm::radians(90 + (hour - 6) * 15), altitude = glm::radians(35.0);
    return {std::sin(azimuth) * std::cos(altitude), std::cos(azimuth) * std::cos(altitude),
            std::sin(altitude)};
}

/// The view in a window of its own, and a clock of its frames.
class Stage {
public:
    explicit Stage(const City& city) : city_(city), clock_(new Qt3DLogic::QFrameAction) {
        view_.resize(windowSize);
        view_.showCity(std::make_shared<const CityArrays>(makeArrays(city)));
        std::vector<std::uint32_t> all(city.buildings.size());
        std::iota(all.begin(), all.end(), 0U);
        faces_ = makeCasterFaces(city, all);
        if (std::getenv("NOONMARK_TRIANGLES") == nullptr)
            view_.setRays(RayScene::over(city).value(), city.buildings);
        view_.camera()->addComponent(clock_);
        view_.show();
        wait(2000);
    }

    CityView& view() { return view_; }

    void showSun(double hour) {
        if (view_.isTraced()) return view_.showTracedSun(towardsSun(hour));
        SunDepthMap map = drawDepths(faces_, hour);
        for (const CasterFaces& crowns : crowns_) {
            const SunDepthMap own = drawDepths(crowns, hour);
            if (map.crowns.empty()) map.crowns = own.depth;
            std::ranges::transform(map.crowns, own.depth, map.crowns.begin(),
                                   [](float a, float b) { return std::max(a, b); });
        }
        view_.sun().show(map);
    }

    void plant(std::shared_ptr<const Trees> trees, int dayOfYear) {
        const CrownMeshes meshes = makeCrownMeshes(*trees);
        crowns_ = {makeCasterFaces(meshes.evergreen)};
        for (const CrownMeshes::Losing& losing : meshes.losingLeaves)
            crowns_.push_back(makeCasterFaces(losing.crowns));
        auto rays = makeCrownRays(trees, {});
        view_.showTrees(std::move(trees), rays.value());
        view_.setTreeDay(dayOfYear);
        wait(500);
    }

    void showResult() {
        GroundPicture picture;
        const Box2 box = middleBox();
        picture.grid = {double(box.low.x), double(box.low.y), 2, 400, 400};
        picture.pixels.assign(picture.grid.size(), {120, 40, 20, 200});
        view_.showPicture(picture);
    }

    // Changes the view at each frame; frames without a change are not drawn.
    void time(const std::string& what, double seconds, const std::function<void(int)>& change) {
        int frames = 0;
        std::clock_t processor = 0;
        QElapsedTimer clock;
        const auto link = QObject::connect(clock_, &Qt3DLogic::QFrameAction::triggered, &view_, [&] {
            if (frames == 0) {
                clock.start();
                processor = std::clock();
            }
            change(frames++);
        });
        change(0);
        // Waiting for events, so that looking for them takes no processor time.
        while (!clock.isValid() || double(clock.elapsed()) < seconds * 1000)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        QObject::disconnect(link);
        const double used = double(std::clock() - processor) * 1000 / CLOCKS_PER_SEC / (frames - 1);
        fmt::print("{:<34} {:6.1f} frames/s, {:7.1f} ms of processor time a frame\n", what,
                   (frames - 1) * 1000.0 / double(clock.elapsed()), used);
        std::fflush(stdout);
    }

    void turn(const std::string& what, double seconds) {
        const CameraPose start = view_.pose();
        time(what, seconds, [&](int frame) {
            CameraPose pose = start;
            pose.headingDeg = start.headingDeg + 1.5 * frame;
            view_.setPose(pose);
        });
        view_.setPose(start);
    }

    void save(const std::string& folder, const std::string& name) {
        if (folder.empty()) return;
        wait(1500);
        QImage image;
        view_.capture([&image](const QImage& made) { image = made; });
        while (image.isNull()) QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
        image.save(QString::fromStdString(folder + "/" + name + ".png"));
    }

    static void wait(int ms) {
        QElapsedTimer clock;
        clock.start();
        while (clock.elapsed() < ms) QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    }

private:
    SunDepthMap drawDepths(const CasterFaces& faces, double hour) const {
        const ViewBounds& bounds = view_.viewBounds();
        return drawSunDepths(faces, towardsSun(hour), {bounds.box, bounds.groundM, bounds.topM}, 2048);
    }

    [[nodiscard]] Box2 middleBox() const {
        const glm::vec2 middle = (bounds(city_).low + bounds(city_).high) * 0.5F;
        return {middle - 400.0F, middle + 400.0F};
    }

    const City& city_;
    Qt3DLogic::QFrameAction* clock_;
    CasterFaces faces_;
    std::vector<CasterFaces> crowns_;  ///< in leaf
    CityView view_;
};

CameraPose fromNearBy(const CityView& view) {
    const ViewBounds& bounds = view.viewBounds();
    CameraPose pose = view.pose();
    const glm::vec2 middle = (bounds.box.low + bounds.box.high) * 0.5F;
    pose.target = {middle.x, middle.y, bounds.groundM};
    pose.distanceM = 700;
    pose.pitchDeg = 25;
    return pose;
}

void timeCameras(Stage& stage, const std::string& how, double seconds, const std::string& folder) {
    const CameraPose whole = stage.view().pose();
    stage.turn("orbit, whole city, " + how, seconds);
    stage.save(folder, "whole-" + how);
    stage.view().setPose(fromNearBy(stage.view()));
    stage.turn("orbit, 700 m, " + how, seconds);
    stage.save(folder, "near-" + how);
    stage.view().setPose(whole);
}

void timeTrees(Stage& stage, const City& city, std::size_t count, double seconds, const std::string& folder) {
    const Box2 box = bounds(city);
    const float sideM = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    std::mt19937 random(7);
    const City planted = withTrees(city, plantOnGround(city, findSquare(city, double(sideM)), count, random));
    constexpr int summer = 172, winter = 15;
    timeCameras(stage, "without trees", seconds, folder);
    stage.plant(planted.trees, summer);
    timeCameras(stage, fmt::format("{} trees in leaf", count), seconds, folder);
    stage.plant(planted.trees, winter);
    timeCameras(stage, fmt::format("{} bare trees", count), seconds, folder);
    stage.plant(planted.trees, summer);
    stage.showSun(9);
    timeCameras(stage, fmt::format("{} trees, sun", count), seconds, folder);
}

}  // namespace

int main(int argc, char** argv) {
    qputenv("QT3D_RENDERER", "opengl");
    const QGuiApplication application(argc, argv);
    const std::string name = argc > 1 ? argv[1] : "sample";
    const double seconds = argc > 2 ? std::stod(argv[2]) : 8;
    const std::string folder = argc > 3 ? argv[3] : "";
    const City city = namedCity(name);
    Stage stage(city);
    fmt::print("{}: {} buildings, {} triangles, {} edges, {} x {} pixels\n", name, city.buildings.size(),
               stage.view().arrays()->triangles.size() / 3, stage.view().arrays()->edges.size() / 2,
               windowSize.width(), windowSize.height());
    if (argc > 4) {
        timeTrees(stage, city, std::stoul(argv[4]), seconds, folder);
        return EXIT_SUCCESS;
    }
    timeCameras(stage, "plain", seconds, folder);
    stage.showResult();
    timeCameras(stage, "result", seconds, folder);
    stage.view().clearPicture();
    stage.showSun(9);
    timeCameras(stage, "sun", seconds, folder);
    stage.time("time bar, whole city", seconds, [&](int frame) { stage.showSun(8 + frame % 80 * 0.1); });
}
