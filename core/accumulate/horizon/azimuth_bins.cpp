#include "core/accumulate/horizon/azimuth_bins.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

namespace noonmark {

namespace {

struct Place {
    std::uint32_t step;
    std::uint32_t bin;
    float tan;
};

// In line with the rays of the reference, which know only the direction.
Place placeOf(const SunStep& step, std::uint32_t index, double widthDeg) {
    const double east = step.direction.x, north = step.direction.y;
    double azimuth = std::atan2(east, north) * 180 / std::numbers::pi;
    if (azimuth < 0) azimuth += 360;
    const double tan = double(step.direction.z) / std::max(std::hypot(east, north), 1e-9);
    return {index, std::uint32_t(azimuth / widthDeg), float(tan)};
}

std::vector<Place> sortedPlaces(const SunSteps& sun, double widthDeg) {
    std::vector<Place> places;
    places.reserve(sun.steps.size());
    for (std::uint32_t i = 0; i < sun.steps.size(); ++i) places.push_back(placeOf(sun.steps[i], i, widthDeg));
    std::ranges::sort(places, [](const Place& a, const Place& b) {
        return std::tie(a.bin, a.tan, a.step) < std::tie(b.bin, b.tan, b.step);
    });
    return places;
}

// Mean of the steps' horizontal directions, each of length 1.
glm::dvec2 meanAway(const SunSteps& sun, std::span<const Place> places) {
    glm::dvec2 sum(0);
    for (const Place& place : places) {
        const glm::vec3 towards = sun.steps[place.step].direction;
        const double length = std::hypot(double(towards.x), double(towards.y));
        if (length > 0) sum -= glm::dvec2(double(towards.x), double(towards.y)) / length;
    }
    const double length = std::hypot(sum.x, sum.y);
    return length > 0 ? sum / length : glm::dvec2(0, 1);  // a sun in the zenith has no azimuth
}

void addBin(BinnedSun& binned, const SunSteps& sun, std::span<const Place> places) {
    std::vector<float> tans;
    for (const Place& place : places) {
        binned.places[place.step] = {std::uint16_t(binned.bins.size()), std::int16_t(tans.size())};
        tans.push_back(place.tan);
    }
    binned.bins.emplace_back(meanAway(sun, places), std::move(tans));
}

}  // namespace

std::uint32_t AzimuthBin::keyOf(float slope) { return std::bit_cast<std::uint32_t>(slope) >> 16U; }

AzimuthBin::AzimuthBin(glm::dvec2 away, std::vector<float> tans)
    : away_(away), tans_(std::move(tans)), lowestKey_(keyOf(tans_.front())) {
    std::size_t rank = 0;
    for (std::uint32_t key = lowestKey_; key <= keyOf(tans_.back()); ++key) {
        while (rank < tans_.size() && keyOf(tans_[rank]) < key) ++rank;
        firstAt_.push_back(std::int16_t(rank));
    }
}

BinnedSun binnedSun(const SunSteps& sun, double widthDeg) {
    const std::vector<Place> places = sortedPlaces(sun, widthDeg);
    BinnedSun binned;
    binned.places.resize(places.size());
    for (std::size_t first = 0; first < places.size();) {
        std::size_t end = first;
        while (end < places.size() && places[end].bin == places[first].bin &&
               end - first < BinnedSun::mostStepsABin)
            ++end;
        addBin(binned, sun, std::span(places).subspan(first, end - first));
        first = end;
    }
    return binned;
}

}  // namespace noonmark
