// Inverse accrual maps against the ray reference over random intervals and places: area error by source
// level, largest cell errors, time.
//
//     iam_bench [FILE or number of buildings] [intervals] [minutes] [nearest hit, m] [margin, m]
#include <fmt/format.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/engines/ray/ray_reference.h"
#include "core/lab/graph/graph_engine.h"
#include "core/lab/inverse/inverse_accrual_map.h"
#include "core/measures/statistics.h"
#include "tests/benchmarks/bench_scene.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

struct Interval {
    Receivers receivers;
    SunSteps sun;
};

/// A square of 400 m at a random place in the city, on a random day and hour with the sun up; dawn and dusk
/// are as likely as noon.
Interval randomInterval(const City& city, double minutes, std::mt19937& random) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const Box2 box = bounds(city);
    const glm::vec2 middle{between(box.low.x + 500, box.high.x - 500),
                           between(box.low.y + 500, box.high.y - 500)};
    Interval interval;
    interval.receivers =
        placeReceiversOnGround(city, makeRegionFromLocalBox({middle - 200.0F, middle + 200.0F}), {1}).value();
    while (interval.sun.steps.size() < 30) {
        Period period{.zone = "America/New_York"};
        period.start =
            CivilDate(std::chrono::sys_days(period.start) + std::chrono::days(int(between(0, 365))));
        period.from = std::chrono::minutes(int(between(4 * 60, 20 * 60)));
        period.hours = minutes / 60;
        interval.sun = computeSunSteps(period, {.place = city.frame.origin()}).value();
    }
    return interval;
}

ShadowField accrued(const City& city, const Interval& interval, const InverseAccrualSettings& settings,
                    double minutes) {
    NoProgress progress;
    const GraphEngine engine(InverseAccrualMap::make(settings).value(),
                             {.intervalMinutes = minutes, .merge = false});
    return engine.accumulate(city, interval.receivers, interval.sun, progress, {}).value();
}

struct Errors {
    std::vector<double> areaPct;
    double cellPct = 0, signedPct = 0, worstMin = 0, seconds = 0;

    void add(const ShadowField& field, const ShadowField& truth, const Receivers& receivers) {
        const ShadowStatistics is = computeStatistics(field), should = computeStatistics(truth);
        const double area = 100 * (is.shadowAreaM2 - should.shadowAreaM2) / should.receiverAreaM2;
        areaPct.push_back(std::abs(area));
        signedPct += area;
        double sum = 0;
        for (const std::uint32_t cell : receivers.cells) {
            const double difference = std::abs(double(field.grossMin[cell]) - double(truth.grossMin[cell]));
            sum += difference;
            worstMin = std::max(worstMin, difference);
        }
        cellPct += 100 * sum / (double(receivers.cells.size()) * field.sunlitMinutesPerDay);
    }

    void print(int levels) {
        std::ranges::sort(areaPct);
        double mean = 0;
        for (const double value : areaPct) mean += value / double(areaPct.size());
        const double count = double(areaPct.size());
        fmt::print(
            "{} levels: area error mean {:.3f} %, median {:.3f} %, max {:.3f} % (signed {:+.3f} %), cell "
            "{:.3f} %, worst cell {:.0f} min, {:.3f} s processor\n",
            levels, mean, areaPct[areaPct.size() / 2], areaPct.back(), signedPct / count, cellPct / count,
            worstMin, seconds);
    }
};

}  // namespace

int main(int argc, char** argv) {
    chooseInstructionSet();
    const auto number = [&](int at, double standard) { return argc > at ? std::stod(argv[at]) : standard; };
    const City city = cityFrom(argc > 1 ? argv[1] : "43000");
    const int intervals = int(number(2, 40));
    const double minutes = number(3, 60);
    InverseAccrualSettings settings{
        .nearestHitM = float(number(4, double(InverseAccrualSettings{}.nearestHitM))),
        .marginM = number(5, InverseAccrualSettings{}.marginM)};
    std::mt19937 random(1);
    std::vector<Errors> errors(6);
    for (int i = 0; i < intervals; ++i) {
        const Interval interval = randomInterval(city, minutes, random);
        NoProgress progress;
        const ShadowField truth =
            RayReference().accumulate(city, interval.receivers, interval.sun, progress, {}).value();
        for (int levels = 1; levels <= 6; ++levels) {
            settings.levels = levels;
            ShadowField field;
            Errors& sum = errors[std::size_t(levels - 1)];
            sum.seconds += secondsOf([&] { field = accrued(city, interval, settings, minutes); }).processor;
            sum.add(field, truth, interval.receivers);
        }
    }
    fmt::print("{} random intervals of {:.0f} min\n", intervals, minutes);
    for (int levels = 1; levels <= 6; ++levels) errors[std::size_t(levels - 1)].print(levels);
}
