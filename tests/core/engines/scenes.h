#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "core/city/city.h"
#include "core/engines/ray/ray_reference.h"
#include "core/engines/ray/ray_scene.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

/// Hand-made scenes with known answers.
namespace noonmark::tests {

/// An axis-aligned solid, local metres.
struct Box3 {
    glm::dvec3 low;
    glm::dvec3 high;
};

inline Ring rectangle(float west, float south, float east, float north) {
    return {{west, south}, {east, south}, {east, north}, {west, north}};
}

inline std::shared_ptr<const Building> buildingOf(Footprint footprint, float bottomM, float topM,
                                                  bool isOverhanging = false) {
    Building building;
    building.parts.push_back({.footprint = std::move(footprint),
                              .bottomM = bottomM,
                              .topM = topM,
                              .isOverhanging = isOverhanging});
    return std::make_shared<const Building>(std::move(building));
}

inline std::shared_ptr<const Building> buildingOf(const Box3& box) {
    return buildingOf(
        {rectangle(float(box.low.x), float(box.low.y), float(box.high.x), float(box.high.y)), {}},
        float(box.low.z), float(box.high.z), box.low.z > 0);
}

inline City cityOf(const std::vector<Box3>& boxes) {
    City city;
    for (const Box3& box : boxes) city.buildings.push_back(buildingOf(box));
    return city;
}

/// Unit vector towards the sun.
inline glm::vec3 towardsSun(double azimuthDeg, double altitudeDeg) {
    const double a = azimuthDeg * std::numbers::pi / 180, e = altitudeDeg * std::numbers::pi / 180;
    return glm::vec3(glm::dvec3{std::cos(e) * std::sin(a), std::cos(e) * std::cos(a), std::sin(e)});
}

struct Sun {
    double azimuthDeg;
    double altitudeDeg;
};

/// Appends a day with these suns in slots 0, 1, 2, ...
inline void addDay(SunSteps& steps, const std::vector<Sun>& suns) {
    steps.days.push_back({.first = std::uint32_t(steps.steps.size()), .count = std::uint32_t(suns.size())});
    std::int32_t slot = 0;
    for (const Sun& sun : suns)
        steps.steps.push_back({.direction = towardsSun(sun.azimuthDeg, sun.altitudeDeg),
                               .azimuthDeg = float(sun.azimuthDeg),
                               .altitudeDeg = float(sun.altitudeDeg),
                               .slot = slot++});
}

inline SunSteps oneDay(const std::vector<Sun>& suns, double stepMinutes = 1) {
    SunSteps steps;
    steps.stepMinutes = stepMinutes;
    addDay(steps, suns);
    return steps;
}

/// Receivers of 1 m (or `cellM`) over a box, without cells under buildings.
inline Receivers receiversOver(const City& city, float west, float south, float east, float north,
                               double cellM = 1) {
    return placeReceiversOnGround(city, makeRegionFromLocalBox({{west, south}, {east, north}}), {cellM})
        .value();
}

inline ShadowField traced(const City& city, const Receivers& receivers, const SunSteps& sun,
                          int threads = 0) {
    NoProgress progress;
    return RayReference({.threads = threads}).accumulate(city, receivers, sun, progress, {}).value();
}

/// Index in the field of the cell that contains a point.
inline std::size_t cellAt(const Grid& grid, double x, double y) {
    return grid.index(int(std::floor((x - grid.westM) / grid.cellM)),
                      int(std::floor((y - grid.southM) / grid.cellM)));
}

/// The slab test in double: whether a ray from `origin` passes through the box grown by `growM` (shrunk if
/// negative).
inline bool passesThrough(const Box3& box, glm::dvec3 origin, glm::dvec3 direction, double growM = 0) {
    double from = 0, to = 1e30;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = box.low[axis] - growM - origin[axis], high = box.high[axis] + growM - origin[axis];
        if (direction[axis] == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        const double a = low / direction[axis], b = high / direction[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

inline bool inShadow(const std::vector<Box3>& boxes, glm::dvec3 origin, glm::dvec3 direction,
                     double growM = 0) {
    for (const Box3& box : boxes)
        if (passesThrough(box, origin, direction, growM)) return true;
    return false;
}

/// Minutes computed in the test itself, step by step.
struct Minutes {
    double gross = 0;
    double continuous = 0;
};

template <class IsShaded>
Minutes minutesOf(const SunSteps& sun, const IsShaded& isShaded) {
    Minutes minutes;
    for (const SunDay& day : sun.days) {
        double run = 0;
        std::int32_t before = -2;
        for (std::uint32_t i = day.first; i < day.first + day.count; ++i) {
            const SunStep& step = sun.steps[i];
            if (step.slot != before + 1) run = 0;
            before = step.slot;
            run = isShaded(glm::dvec3(step.direction)) ? run + sun.stepMinutes : 0;
            if (run > 0) minutes.gross += sun.stepMinutes / double(sun.days.size());
            minutes.continuous = std::max(minutes.continuous, run);
        }
    }
    return minutes;
}

/// Boxes on a jittered lattice: never overlapping, some wall to wall, some raised above the ground.
inline std::vector<Box3> randomBoxes(std::uint32_t seed, int perSide) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::vector<Box3> boxes;
    for (int row = 0; row < perSide; ++row)
        for (int column = 0; column < perSide; ++column) {
            const double west = column * 20, south = row * 20, bottom = between(0, 1) < 0.1 ? 5 : 0;
            const double east = between(0, 1) < 0.3 ? west + 20 : west + between(6, 18);
            // Drawn one by one: compilers differ in the order in which they evaluate arguments.
            const double top = bottom + between(3, 60);
            const double north = south + between(6, 18);
            boxes.push_back({glm::dvec3(glm::vec3(glm::dvec3(west, south, bottom))),
                             glm::dvec3(glm::vec3(glm::dvec3(east, north, top)))});
        }
    return boxes;
}

/// A day of suns from east through south (or north) to west.
inline std::vector<Sun> arc(int steps, double noonAltitudeDeg, bool sunInNorth = false) {
    std::vector<Sun> suns;
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) / steps;
        const double azimuth = sunInNorth ? 90 - 180 * t : 90 + 180 * t;
        suns.push_back(
            {azimuth < 0 ? azimuth + 360 : azimuth, noonAltitudeDeg * std::sin(t * std::numbers::pi)});
    }
    return suns;
}

/// Days of a year at a latitude: every `every` days, 8 h around noon.
inline SunSteps days(double latitudeDeg, int every, int stepMinutes = 1) {
    SunSteps steps;
    steps.stepMinutes = stepMinutes;
    const double radian = std::numbers::pi / 180, latitude = latitudeDeg * radian;
    for (int day = 0; day < 365; day += every) {
        const double declination = -23.44 * radian * std::cos(2 * std::numbers::pi * (day + 10) / 365);
        std::vector<Sun> suns;
        for (int minute = -240; minute < 240; minute += stepMinutes) {
            const double hour = minute * radian / 4;
            const double up = std::sin(latitude) * std::sin(declination) +
                              std::cos(latitude) * std::cos(declination) * std::cos(hour);
            const double east = -std::cos(declination) * std::sin(hour);
            const double north = std::cos(latitude) * std::sin(declination) -
                                 std::sin(latitude) * std::cos(declination) * std::cos(hour);
            const double azimuth = std::atan2(east, north) / radian;
            if (up > 0) suns.push_back({azimuth < 0 ? azimuth + 360 : azimuth, std::asin(up) / radian});
        }
        addDay(steps, suns);
    }
    return steps;
}

}  // namespace noonmark::tests
