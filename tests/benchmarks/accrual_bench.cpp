// Compares the shadow accrual map with shadow maps, in OpenGL and on the CPU: first the masks, which must be
// equal, then the times in alternating runs, then the parts of OpenGL's time.
//
//     accrual_bench [FILE or number of buildings] [rounds] [map size]
#include <fmt/format.h>

#include <bit>
#include <functional>
#include <memory>

#include "core/engines/common/shadow_reach.h"
#include "core/lab/accrual/shadow_accrual_map.h"
#include "render/lab/depth_maps.h"
#include "render/lab/gl_api.h"
#include "render/lab/gl_shadow_maps.h"
#include "tests/benchmarks/accrual_scene.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

using Masks = std::vector<ShadowMask>;

/// One method of shading the hour.
struct Contender {
    std::string name;
    std::unique_ptr<IntervalScene> scene;
    bool stepByStep = false;  ///< one interval per step
    std::vector<double> wall, processor;
    Masks masks;

    void shade(const SunInterval& hour) {
        if (!stepByStep) return check(scene->shade(hour, masks, {}));
        Masks one(masks.size());
        std::ranges::fill(masks, ShadowMask{0});
        for (int step = 0; step < hour.steps; ++step) {
            check(scene->shade({hour.at(step), hour.at(step), 1}, one, {}));
            for (std::size_t i = 0; i < one.size(); ++i) masks[i] |= one[i] << unsigned(step);
        }
    }

    static void check(const Result<void>& done) {
        if (done) return;
        fmt::print(stderr, "{}\n", done.error().text());
        std::exit(EXIT_FAILURE);
    }
};

Contender contender(std::string name, const std::shared_ptr<const IntervalEngine>& engine,
                    const HourScene& scene, bool stepByStep = false) {
    return {std::move(name),
            engine->prepare(scene.city, scene.receivers, scene.sun, {}).value(),
            stepByStep,
            {},
            {},
            Masks(scene.receivers.cells.size())};
}

double differentPercent(const Masks& a, const Masks& b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); ++i) different += std::size_t(std::popcount(a[i] ^ b[i]));
    return 100.0 * double(different) / (60.0 * double(a.size()));
}

void raceInTurn(std::vector<Contender>& all, const SunInterval& hour, int rounds) {
    for (Contender& one : all) one.shade(hour);  // creates maps and shaders; the result is checked below
    for (int round = 0; round < rounds; ++round)
        for (Contender& one : all) {
            const Seconds seconds = secondsOf([&] { one.shade(hour); });
            one.wall.push_back(seconds.wall);
            one.processor.push_back(seconds.processor);
        }
}

void printTable(const std::vector<Contender>& all) {
    const Contender& base = all.front();
    for (const Contender& one : all)
        fmt::print(
            "{:42} {:7.4f} s wall ({:5.1f} x)  {:7.4f} s processor ({:5.1f} x)  other answers {:.5f} %\n",
            one.name, median(one.wall), median(base.wall) / median(one.wall), median(one.processor),
            median(base.processor) / median(one.processor), differentPercent(one.masks, base.masks));
}

/// The cost of 60 passes and of one draw in OpenGL, part by part.
class Anatomy {
public:
    Anatomy(const HourScene& scene, const AccrualSettings& settings, const GlLimits& limits)
        : scene_(scene),
          settings_(settings),
          limits_(limits),
          frame_(makeGroundFrame(scene.receivers.grid, settings.mapSize, settings.texelsOnCells)),
          masks_(scene.receivers.cells.size()) {
        const CasterFaces faces =
            makeCasterFaces(scene.city, findBuildingsInReach(scene.city, scene.receivers, scene.sun));
        casters_ =
            placeCasters(faces, frame_.placed(faces.points), frame_, scene.interval(), settings.side, {});
        SurfacePoints cells;
        for (const std::uint32_t cell : scene.receivers.cells)
            cells.positions.push_back(scene.receivers.position(cell));
        cells.normals.assign(cells.size(), {0, 0, 1});
        receivers_ = placeSurface(cells, frame_);
    }

    // Drawing cannot be timed alone: software OpenGL skips work whose result is not used.
    void print(const char* name, int layers) {
        const auto maps = DepthMaps::make(limits_, frame_.columns, frame_.rows, layers).value();
        maps->take(frame_, receivers_, settings_);
        maps->take(casters_, scene_.interval());
        const auto each = [&](auto&& work) {
            for (int step = 0; step < scene_.interval().steps; step += layers) work(step);
            Contender::check(maps->read(masks_));
        };
        const auto drawAndLook = [&](int step) { maps->draw(step, layers), maps->lookUp(step, layers); };
        const std::uint64_t fragments = fragmentsOf([&] { each(drawAndLook); });
        const GlWork counted = maps->work();
        const double all = best([&] { each(drawAndLook); });
        const double looking = best([&] { each([&](int step) { maps->lookUp(step, layers); }); });
        fmt::print(
            "{:24} {:3} passes, {:3} draw calls, {} vertices, {} fragments kept, {} lookups | processor: "
            "{:.3f} "
            "s, of which looking up {:.3f}\n",
            name, counted.passes, counted.drawCalls, counted.vertices, fragments, counted.lookups, all,
            looking);
    }

private:
    // Counts fragments that were nearer to the sun than the stored depth.
    static std::uint64_t fragmentsOf(const std::function<void()>& work) {
        GLuint query = 0;
        glGenQueries(1, &query);
        glBeginQuery(GL_SAMPLES_PASSED, query);
        work();
        glEndQuery(GL_SAMPLES_PASSED);
        GLuint64 count = 0;
        glGetQueryObjectui64v(query, GL_QUERY_RESULT, &count);
        glDeleteQueries(1, &query);
        return count;
    }

    static double best(const std::function<void()>& work) {
        Seconds seconds;
        for (int i = 0; i < 3; ++i) seconds.keepBest(secondsOf(work));
        return seconds.processor;
    }

    const HourScene& scene_;
    AccrualSettings settings_;
    GlLimits limits_;
    MapFrame frame_;
    IntervalCasters casters_;
    PlacedSurface receivers_;
    Masks masks_;
};

}  // namespace

int main(int argc, char** argv) {
    chooseInstructionSet();
    const HourScene scene = hourScene(argc > 1 ? argv[1] : "43000");
    const int rounds = argc > 2 ? std::stoi(argv[2]) : 5;
    const AccrualSettings stretched{.mapSize = argc > 3 ? std::stoi(argv[3]) : 1024, .texelsOnCells = false};
    AccrualSettings onCells = stretched;
    onCells.texelsOnCells = true;
    const auto processor = ShadowAccrualMap::make(stretched).value();
    const auto baseline = GlShadowMaps::make(GlPasses::oneAStep, stretched);
    std::vector<Contender> all;
    if (baseline) {
        all.push_back(contender("shadow map a step, OpenGL", *baseline, scene));
        all.push_back(contender("accrual map, OpenGL",
                                GlShadowMaps::make(GlPasses::oneAnInterval, stretched).value(), scene));
    } else {
        fmt::print("{}\n", baseline.error().text());
    }
    all.push_back(contender("shadow map a step, processor", processor, scene, true));
    all.push_back(contender("accrual map, processor", processor, scene));
    all.push_back(
        contender("accrual map, processor, texels on cells", ShadowAccrualMap::make(onCells).value(), scene));
    raceInTurn(all, scene.interval(), rounds);
    fmt::print("{} receivers, 60 steps, map {}, medians of {} rounds\n", scene.receivers.cells.size(),
               stretched.mapSize, rounds);
    printTable(all);
    if (!baseline) return 0;
    const auto context = GlContext::make().value();
    const GlContext::Current current(*context);
    fmt::print("{}, {}\n", context->limits().device, context->limits().version);
    Anatomy anatomy(scene, stretched, context->limits());
    anatomy.print("shadow map a step", 1);
    anatomy.print("accrual map", 60);
}
