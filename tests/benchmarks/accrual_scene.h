#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/lab/graph/interval_engine.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"
#include "tests/benchmarks/bench_scene.h"

/// Shared by the benchmarks of accrual maps: an hour of 60 steps over 800 x 800 cells.
namespace noonmark::bench {

struct HourScene {
    City city;
    Receivers receivers;
    SunSteps sun;
    [[nodiscard]] SunInterval interval() const {
        return {glm::dvec3(sun.steps.front().direction), glm::dvec3(sun.steps.back().direction),
                int(sun.steps.size())};
    }
};

/// 800 x 800 cells of 1 m in the centre of a city; 21 March 2026, 9:00 to 10:00 in New York, every minute.
inline HourScene hourScene(const std::string& cityName) {
    HourScene scene;
    scene.city = cityFrom(cityName);
    scene.receivers = placeReceiversOnGround(scene.city, findMiddle(scene.city), {1}).value();
    scene.sun =
        computeSunSteps({.hours = 1, .zone = "America/New_York"}, {.place = scene.city.frame.origin()})
            .value();
    return scene;
}

inline double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// Errors of minutes against those of rays, in per cent of the period; `p99` and `worst` are over receivers.
struct MinuteError {
    double area = 0;
    double mean = 0;
    double p99 = 0;
    double worst = 0;
};

inline MinuteError errorOf(const std::vector<double>& minutes, const std::vector<double>& truth,
                           double period) {
    MinuteError error;
    std::vector<double> differences;
    for (std::size_t i = 0; i < minutes.size(); ++i) {
        error.area += minutes[i] - truth[i];
        differences.push_back(100 / period * std::abs(minutes[i] - truth[i]));
        error.mean += differences.back();
    }
    std::ranges::sort(differences);
    const double count = double(minutes.size());
    return {100 / period * error.area / count, error.mean / count,
            differences[std::size_t(0.99 * (count - 1))], differences.back()};
}

}  // namespace noonmark::bench
