// The error of shadow accrual maps against rays, by map size, side, bias and warp, on the ground and on the
// surfaces that a camera sees.
//
//     accrual_error_bench [FILE or number of buildings]
#include <fmt/format.h>

#include "core/engines/ray/ray_reference.h"
#include "core/engines/ray/ray_scene.h"
#include "core/engines/ray/surface_rays.h"
#include "core/engines/ray/visible_surface.h"
#include "core/lab/accrual/shadow_accrual_map.h"
#include "core/lab/accrual/surface_accrual.h"
#include "core/lab/graph/graph_engine.h"
#include "tests/benchmarks/accrual_scene.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

constexpr DirectionGraphSettings everyHour{.merge = false};

std::vector<double> minutesOf(const ShadowField& field, const Receivers& receivers) {
    std::vector<double> minutes;
    for (const std::uint32_t cell : receivers.cells) minutes.push_back(double(field.grossMin[cell]));
    return minutes;
}

std::vector<double> minutesOf(const SurfaceShadow& shadow) {
    return {shadow.grossMin.begin(), shadow.grossMin.end()};
}

void print(const std::string& name, const MinuteError& error, const Seconds& seconds) {
    fmt::print(
        "  {:40} area {:+.4f} %  cell mean {:.4f} %  p99 {:6.2f} %  worst {:6.2f} %  {:.3f} s processor\n",
        name, error.area, error.mean, error.p99, error.worst, seconds.processor);
}

/// Settings with a name.
struct Choice {
    std::string name;
    AccrualSettings settings;
};

void onTheGround(const HourScene& scene) {
    NoProgress progress;
    const auto truth =
        minutesOf(RayReference().accumulate(scene.city, scene.receivers, scene.sun, progress, {}).value(),
                  scene.receivers);
    std::vector<Choice> choices{{"1024 at most, on cells", {}},
                                {"the same, faces towards the sun", {.side = CasterSide::towardsSun}},
                                {"the same, bias 0.1 m", {.biasM = 0.1F}},
                                {"the same, bias 1 m", {.biasM = 1}}};
    for (const int size : {256, 512, 1024, 2048, 4096})
        choices.push_back({fmt::format("{} stretched", size), {.mapSize = size, .texelsOnCells = false}});
    fmt::print("Ground, {} cells\n", truth.size());
    for (const Choice& choice : choices) {
        const GraphEngine engine(ShadowAccrualMap::make(choice.settings).value(), everyHour);
        std::vector<double> minutes;
        const Seconds seconds = secondsOf([&] {
            minutes =
                minutesOf(engine.accumulate(scene.city, scene.receivers, scene.sun, progress, {}).value(),
                          scene.receivers);
        });
        print(choice.name, errorOf(minutes, truth, double(scene.sun.steps.size())), seconds);
    }
}

/// A camera above the centre of a city.
struct View {
    std::string name;
    glm::dvec3 eye;  ///< relative to the centre
};

std::vector<Choice> viewChoices() {
    std::vector<Choice> choices;
    for (const int size : {1024, 4096})
        for (const bool warp : {true, false})
            choices.push_back({fmt::format("{}{}", size, warp ? ", warped" : ", not warped"),
                               {.mapSize = size, .warp = warp}});
    constexpr auto lit = CasterSide::towardsSun;
    choices.push_back({"1024, towards the sun, no bias", {.side = lit}});
    choices.push_back({"1024, towards, slope 0.5", {.slopeBias = 0.5F, .side = lit}});
    choices.push_back({"1024, towards, slope 1, bias 0.05", {.biasM = 0.05F, .slopeBias = 1, .side = lit}});
    choices.push_back({"1024, towards, slope 2, bias 0.1", {.biasM = 0.1F, .slopeBias = 2, .side = lit}});
    return choices;
}

void onWhatIsSeen(const HourScene& scene, const RayScene& rays, const View& view) {
    const Box2 box = bounds(scene.city);
    const glm::dvec3 middle(glm::dvec2(box.low + box.high) * 0.5, 0);
    const SurfacePoints points =
        findVisibleSurface(rays, !scene.city.terrain, makeCamera(middle + view.eye, middle, 40, 800, 800))
            .value()
            .points;
    NoProgress progress;
    const auto truth =
        minutesOf(SurfaceRays().accumulate(scene.city, points, scene.sun, progress, {}).value());
    fmt::print("{}, {} points on ground, roofs and facades\n", view.name, truth.size());
    for (const Choice& choice : viewChoices()) {
        const auto engine = SurfaceAccrual::make(choice.settings, everyHour).value();
        std::vector<double> minutes;
        const Seconds seconds = secondsOf([&] {
            minutes = minutesOf(engine->accumulate(scene.city, points, scene.sun, progress, {}).value());
        });
        print(choice.name, errorOf(minutes, truth, double(scene.sun.steps.size())), seconds);
    }
}

}  // namespace

int main(int argc, char** argv) {
    chooseInstructionSet();
    const HourScene scene = hourScene(argc > 1 ? argv[1] : "43000");
    onTheGround(scene);
    const RayScene rays = RayScene::over(scene.city).value();
    for (const View& view : {View{"From above", {0, 0, 1200}}, View{"At 45 degrees", {0, -900, 900}},
                             View{"Low over the roofs", {-700, -300, 250}}})
        onWhatIsSeen(scene, rays, view);
}
