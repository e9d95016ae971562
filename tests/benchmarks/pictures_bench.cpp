// Pictures while long work runs: how many a second, and the longest pause between two, over the first seconds
// of a study of a year and of the exploration of a view at every pixel.
//
//     pictures_bench [FILE or number of buildings] [seconds for each]
#include <fmt/format.h>

#include <atomic>
#include <mutex>

#include "app/input/all_engines.h"
#include "app/window/open_city.h"
#include "app/window/view_refinement.h"
#include "core/accumulate/partial_field.h"
#include "core/accumulate/surface_accrual.h"
#include "core/accumulate/surface_rays.h"
#include "core/stopwatch.h"
#include "tests/benchmarks/bench_scene.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

/// Takes every picture that a window would, and ends the work after a while.
class Onlooker final : public Progress, public PartialSink {
public:
    explicit Onlooker(double seconds) : seconds_(seconds) {}

    void report(double, std::string_view) override {
        if (watch_.seconds() > seconds_) stop_.request_stop();
    }
    PartialSink* partials() override { return this; }
    [[nodiscard]] bool wants() const override { return watch_.seconds() > last_ + 0.14; }  // as in Job
    void take(PartialField) override { seen(); }

    void seen() {
        const double now = watch_.seconds();
        longest_ = std::max(longest_, now - last_);
        last_ = now;
        ++pictures_;
    }
    [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
    [[nodiscard]] bool tired() const { return watch_.seconds() > seconds_; }

    void print(std::string_view what) const {
        fmt::print("{:<28} {:6.1f} pictures/s, longest pause {:5.2f} s, {} in {:.1f} s\n", what,
                   pictures_ / last_, longest_, pictures_, last_.load());
        std::fflush(stdout);
    }

private:
    double seconds_;
    Stopwatch watch_;
    std::stop_source stop_;
    std::atomic<double> last_ = 0;
    double longest_ = 0;
    int pictures_ = 0;
};

void study(const OpenCity& city, std::string_view engine, double seconds) {
    const Receivers receivers = receiversOnGround(city.city(), middleOf(city.city()), {1}).value();
    const SunSteps sun =
        sunSteps({.days = 365, .zone = "America/New_York"}, {.place = city.city().frame.origin()}).value();
    Onlooker onlooker(seconds);
    const auto accumulator = makeAccumulator(engine, {}, allEngines());
    if (!accumulator) return fmt::print("{:<28} {}\n", engine, accumulator.error().text());
    (void)(*accumulator)->accumulate(city.city(), receivers, sun, onlooker, onlooker.token());
    onlooker.print(fmt::format("{}, a year", engine));
}

void explore(const std::shared_ptr<const OpenCity>& city, int days, const SurfaceEngine& engine,
             std::string_view name, double seconds) {
    ViewQuestion question{city,
                          {glm::dvec3(0), 900, 20, 40},
                          {40, 1360, 800},
                          {.days = days, .zone = "America/New_York"},
                          {.place = city->city().frame.origin()},
                          nullptr};
    Onlooker onlooker(seconds);
    auto answer = refined(question, nullptr, engine, onlooker, onlooker.token());
    while (answer && !onlooker.tired()) {
        onlooker.seen();
        if (isFinest(*answer)) break;
        question.sun = answer->sun;
        if (answer->turn.tests > 0) question.turnTests = turnTestsAfter(*answer);
        answer = refined(question, &*answer, engine, onlooker, onlooker.token());
    }
    onlooker.print(fmt::format("exploring {}, {} days", name, days));
}

}  // namespace

int main(int argc, char** argv) {
    const std::string name = argc > 1 ? argv[1] : "43000";
    const double seconds = argc > 2 ? std::stod(argv[2]) : 10;
    OpenCity opened;
    opened.loaded.read.city = cityFrom(name);
    opened.arrays = std::make_shared<const CityArrays>(arraysOf(opened.city()));
    opened.picker = ScenePicker(opened.city(), RayScene::over(opened.city()).value());
    const auto city = std::make_shared<const OpenCity>(std::move(opened));
    for (const int days : {1, 365}) {
        explore(city, days, {std::make_shared<SurfaceRays>(city->picker.scene())}, "by rays", seconds);
        explore(city, days, {SurfaceAccrual::make({}, {}).value(), false}, "by maps", seconds);
    }
    for (const Engine& engine : allEngines()) study(*city, engine.info.key, seconds);
}
