#include "core/measures/places/place_points.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/engines/common/shadow_reach.h"
#include "core/engines/common/sun_packets.h"
#include "core/engines/ray/ray_reference.h"
#include "core/measures/places/place_run.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

Box2 boxOfAll(std::span<const Place> places) {
    Box2 box;
    for (const Place& place : places)
        for (const Footprint& polygon : place.polygons) box.add(bounds(polygon));
    return box;
}

/// The buildings whose shadow can fall on a place, outside the centres of its cells too.
std::vector<std::uint32_t> findInReach(const City& city, std::span<const Place> places, double lowestM,
                                       const SunSteps& sun) {
    const Box2 box = boxOfAll(places);
    const ShadowReach reach(sun);
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < city.buildings.size(); ++i) {
        const Building& building = *city.buildings[i];
        if (reach.touches(bounds(building), double(topM(building)) - lowestM, box))
            found.push_back(std::uint32_t(i));
    }
    return found;
}

double lowestM(const PlaceReceivers& receivers, std::optional<float> planeZ) {
    constexpr double belowCentresM = 20;  // the ground beside the lowest centre
    if (planeZ) return double(*planeZ);
    const bool flat = receivers.receivers.flat();
    return lowestGroundM(receivers.receivers) - (flat ? 0 : belowCentresM);
}

bool isIn(const std::vector<Footprint>& polygons, glm::dvec2 point) {
    return std::ranges::any_of(polygons, [&](const Footprint& one) { return contains(one, point); });
}

SunSteps stepsOf(const PlaceShadow& day) {
    SunSteps sun;
    sun.steps.assign(day.steps.begin(), day.steps.end());
    sun.days.push_back({.first = 0, .count = std::uint32_t(day.steps.size())});
    return sun;
}

StepMasks traceMasks(const RayScene& scene, std::span<const glm::vec3> origins,
                     std::span<const SunPacket> packets, std::size_t steps) {
    StepMasks masks(origins.size(), steps);
    std::vector<std::uint32_t> blocked(origins.size());
    for (std::size_t i = 0; i < packets.size(); ++i) {
        scene.blockedLanes(origins, packets[i].directions, blocked);
        for (std::size_t point = 0; point < origins.size(); ++point)
            for (int lane = 0; lane < packets[i].directions.count; ++lane)
                if ((blocked[point] >> lane & 1U) != 0)
                    masks.shade(i * DirectionPacket::capacity + std::size_t(lane), point);
    }
    return masks;
}

}  // namespace

Result<PlacePoints> PlacePoints::over(std::span<const City* const> cities, std::span<const Place> places,
                                      const PlaceReceivers& receivers, std::optional<float> planeZ,
                                      const SunSteps& sun, const std::stop_token& stop) {
    PlacePoints points;
    points.ground_ = cities.front();
    points.places_ = places;
    points.receivers_ = &receivers;
    points.planeZ_ = planeZ;
    points.built_ = findBuiltGround(cities, places);
    for (const City* city : cities) {
        const double lowest = lowestM(receivers, planeZ);
        auto scene = RayScene::over(*city, findInReach(*city, places, lowest, sun), stop);
        if (!scene) return tl::make_unexpected(scene.error());
        points.scenes_.push_back(*std::move(scene));
    }
    return points;
}

glm::dvec2 PlacePoints::centreOf(std::size_t place, std::size_t cell) const {
    const Receivers& receivers = receivers_->receivers;
    const std::uint32_t index = receivers.cells[receivers_->receiverOf(place, cell)];
    return glm::dvec2(receivers.position(index));
}

bool PlacePoints::isOpen(std::size_t place, glm::dvec2 point) const {
    return isIn(places_[place].polygons, point) && !isIn(built_[place], point);
}

glm::vec3 PlacePoints::originAt(glm::dvec2 point) const {
    const float z = planeZ_ ? *planeZ_ : groundAt(*ground_, point);
    return placeRayOrigin({glm::vec2(point), z});
}

std::vector<glm::dvec2> PlacePoints::around(std::size_t place, std::span<const glm::dvec2> middles,
                                            const PointGrid& grid) const {
    std::set<std::pair<std::int64_t, std::int64_t>> squares;  // by row, so that neighbours follow each other
    for (const glm::dvec2 middle : middles) {
        const auto low = glm::floor((middle - grid.reachM) / grid.spacingM + 0.5),
                   high = glm::floor((middle + grid.reachM) / grid.spacingM + 0.5);
        for (auto row = std::int64_t(low.y); row < std::int64_t(high.y); ++row)
            for (auto column = std::int64_t(low.x); column < std::int64_t(high.x); ++column)
                squares.emplace(row, column);
    }
    std::vector<glm::dvec2> points;
    for (const auto& [row, column] : squares) {
        const glm::dvec2 point = (glm::dvec2(column, row) + 0.5) * grid.spacingM;
        if (isOpen(place, point)) points.push_back(point);
    }
    return points;
}

PlaceShadow PlacePoints::shade(std::span<const glm::dvec2> points, const PlaceShadow& day) const {
    const FlushDenormals flush;
    std::vector<glm::vec3> origins;
    for (const glm::dvec2 point : points) origins.push_back(originAt(point));
    const std::vector<SunPacket> packets = packSteps(stepsOf(day));
    PlaceShadow shadow{.day = day.day, .steps = day.steps, .cellAreaM2 = 0, .stepMinutes = day.stepMinutes};
    shadow.baseline = traceMasks(scenes_.front(), origins, packets, day.steps.size());
    shadow.scenario = traceMasks(scenes_[1], origins, packets, day.steps.size());
    if (scenes_.size() == 2) return shadow;
    const StepMasks bare = traceMasks(scenes_[2], origins, packets, day.steps.size());
    removeShadow(shadow.baseline, bare);
    removeShadow(shadow.scenario, bare);
    return shadow;
}

}  // namespace noonmark
