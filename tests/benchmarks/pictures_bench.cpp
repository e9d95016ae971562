// Intermediate pictures during long computations: their number per second and the longest pause between two,
// in the first seconds of a study of a year and of the exploration of a view at every pixel; and the cost of
// the pictures for a study of a day.
//
//     pictures_bench [FILE or number of buildings] [seconds for each] [engine]
//
// Other running programs lengthen the pauses.
#include <fmt/format.h>

#include <ctime>
#include <functional>
#include <mutex>

#include "app/gui/session/study/open_city.h"
#include "app/gui/view/exploration/view_refinement.h"
#include "app/input/all_engines.h"
#include "core/base/progress.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/ray/surface_rays.h"
#include "core/lab/accrual/surface_accrual.h"
#include "tests/benchmarks/bench_scene.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

/// Receives the pictures as a window would, and stops the work after a while.
class Onlooker final : public Progress, public PartialSink {
public:
    explicit Onlooker(double seconds) : seconds_(seconds) {}

    void report(double, std::string_view) override {
        if (tired()) stop_.request_stop();
    }
    [[nodiscard]] bool wants() const override {
        if (tired()) stop_.request_stop();
        const std::scoped_lock lock(mutex_);
        return pace_.due(watch_.seconds());
    }
    void take(PartialField partial) override {
        if (!shows || shows(partial)) return seen();
        const std::scoped_lock lock(mutex_);
        pace_.taken(watch_.seconds());
    }
    std::function<bool(const PartialField&)> shows;  ///< whether the window would show it; null: always

    void seen() {
        const std::scoped_lock lock(mutex_);
        const double now = watch_.seconds();
        if (pictures_ == 0) first_ = now;
        if (pictures_ > 0) longest_ = std::max(longest_, now - last_);
        last_ = now;
        pace_.taken(now);
        ++pictures_;
    }
    [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
    [[nodiscard]] bool tired() const { return watch_.seconds() > seconds_; }

    void print(std::string_view what) const {
        if (pictures_ == 0) return fmt::print("{:<28} no picture\n", what);
        fmt::print(
            "{:<28} {:6.1f} pictures/s, the first after {:4.2f} s, longest pause {:4.2f} s, {} in {:.1f} s\n",
            what, (pictures_ - 1) / std::max(1e-9, last_ - first_), first_, longest_, pictures_, last_);
        std::fflush(stdout);
    }

private:
    double seconds_;
    mutable std::mutex mutex_;
    Stopwatch watch_;
    mutable std::stop_source stop_;
    PartialPace pace_;
    double first_ = 0, last_ = 0, longest_ = 0;
    int pictures_ = 0;
};

/// A study of the central region with days of 6 h.
struct Question {
    Receivers receivers;
    SunSteps sun;

    Question(const City& city, int days)
        : receivers(placeReceiversOnGround(city, findMiddle(city), {1}).value()),
          sun(computeSunSteps({.days = days, .zone = "America/New_York"}, {.place = city.frame.origin()})
                  .value()) {}
};

void picturesOf(const City& city, const Question& asked, const Engine& engine, std::string_view name,
                double seconds) {
    Onlooker onlooker(seconds);
    (void)engine.accumulate(city, asked.receivers, asked.sun, onlooker, onlooker.token());
    onlooker.print(fmt::format("{}, a year", name));
}

// The same work with and without receiving pictures, alternately.
void watchingCost(const City& city, const Question& asked, const Engine& engine, std::string_view name) {
    Seconds watched, alone;
    for (int round = 0; round < 3; ++round) {
        watched.keepBest(secondsOf([&] {
            Onlooker onlooker(1e9);
            (void)engine.accumulate(city, asked.receivers, asked.sun, onlooker, {});
        }));
        NoProgress nobody;
        alone.keepBest(
            secondsOf([&] { (void)engine.accumulate(city, asked.receivers, asked.sun, nobody, {}); }));
    }
    fmt::print("{:<28} {:.3f} s of processor time for a day, watched {:.3f} s: {:+.1f} %\n", name,
               alone.processor, watched.processor, 100 * (watched.processor / alone.processor - 1));
    std::fflush(stdout);
}

void explore(const std::shared_ptr<const OpenCity>& city, int days, const ViewEngine& engine,
             std::string_view name, double seconds) {
    ViewQuestion question{city,
                          {glm::dvec3(0), 900, 20, 40},
                          {40, 1360, 800},
                          {.days = days, .zone = "America/New_York"},
                          {.place = city->city().frame.origin()},
                          nullptr};
    Onlooker onlooker(seconds);
    onlooker.shows = [](const PartialField&) { return false; };  // nothing is known of the view yet
    auto answer = refineView(question, nullptr, engine, onlooker, onlooker.token());
    while (answer && !onlooker.tired()) {
        onlooker.seen();
        if (isFinest(*answer)) break;
        question.sun = answer->sun;
        if (answer->turn.tests > 0) question.turnTests = turnTestsAfter(*answer);
        const ViewAnswer before = *answer;
        onlooker.shows = [&before](const PartialField& partial) {
            return withRunning(before, partial).has_value();
        };
        answer = refineView(question, &before, engine, onlooker, onlooker.token());
    }
    onlooker.print(fmt::format("exploring {}, {} days", name, days));
}

}  // namespace

int main(int argc, char** argv) {
    chooseInstructionSet();
    const std::string name = argc > 1 ? argv[1] : "43000";
    const double seconds = argc > 2 ? std::stod(argv[2]) : 10;
    const std::string only = argc > 3 ? argv[3] : "";
    OpenCity opened;
    opened.loaded.read.city = cityFrom(name);
    opened.arrays = std::make_shared<const CityArrays>(makeArrays(opened.city()));
    opened.picker = ScenePicker(opened.city(), RayScene::over(opened.city()).value());
    const auto city = std::make_shared<const OpenCity>(std::move(opened));
    for (const int days : only.empty() || only == "explore" ? std::vector{1, 365} : std::vector<int>{}) {
        explore(city, days, {std::make_shared<SurfaceRays>(city->picker.scene())}, "by rays", seconds);
        explore(city, days, {SurfaceAccrual::make({}, {}).value(), false}, "by maps", seconds);
    }
    const Question year(city->city(), 365), day(city->city(), 1);
    for (const EngineEntry& engine : allEngines()) {
        if (!only.empty() && only != engine.info.key) continue;
        const auto made = makeEngine(engine.info.key, {}, allEngines());
        if (!made) {
            fmt::print("{:<28} {}\n", engine.info.key, made.error().text());
            continue;
        }
        picturesOf(city->city(), year, **made, engine.info.key, seconds);
        watchingCost(city->city(), day, **made, engine.info.key);
    }
}
