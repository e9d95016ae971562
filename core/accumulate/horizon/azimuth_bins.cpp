#include "core/accumulate/horizon/azimuth_bins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace noonmark {

namespace {

struct Place {
    std::uint32_t step;
    std::uint32_t bin;
    HorizonCode sun;
};

// In line with the rays of the reference, which know only the direction.
Place placeOf(const SunStep& step, std::uint32_t index, double widthDeg) {
    const double east = step.direction.x, north = step.direction.y;
    double azimuth = std::atan2(east, north) * 180 / std::numbers::pi;
    if (azimuth < 0) azimuth += 360;
    const double tan = double(step.direction.z) / std::max(std::hypot(east, north), 1e-9);
    return {index, std::uint32_t(azimuth / widthDeg), codeOfSun(tan)};
}

std::vector<Place> sortedPlaces(const SunSteps& sun, double widthDeg) {
    std::vector<Place> places;
    places.reserve(sun.steps.size());
    for (std::uint32_t i = 0; i < sun.steps.size(); ++i) places.push_back(placeOf(sun.steps[i], i, widthDeg));
    std::ranges::sort(places, [](const Place& a, const Place& b) {
        return std::tie(a.bin, a.sun, a.step) < std::tie(b.bin, b.sun, b.step);
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

void addBin(BinnedSun& binned, glm::dvec2 away, std::span<const Place> places) {
    AzimuthBin bin{places.front().bin, away, {}};
    for (const Place& place : places) {
        binned.places[place.step] = {std::uint16_t(binned.bins.size()), place.sun};
        bin.suns.push_back(place.sun);
    }
    binned.bins.push_back(std::move(bin));
}

}  // namespace

glm::dvec2 middleAway(std::uint32_t bin, double widthDeg) {
    const double azimuth = (bin + 0.5) * widthDeg * std::numbers::pi / 180;
    return {-std::sin(azimuth), -std::cos(azimuth)};
}

HiddenSuns::HiddenSuns(std::span<const HorizonCode> suns, std::span<const HorizonCode> others) {
    int low = std::numeric_limits<int>::max(), high = std::numeric_limits<int>::lowest();
    for (const auto& some : {suns, others})
        if (!some.empty()) {
            low = std::min(low, int(some.front()));
            high = std::max(high, int(some.back()));
        }
    if (low <= high) {
        lowest_ = low;
        last_ = high - low + 1;
    }
    counts_.assign(std::size_t(last_) + 1, 0);
    for (const HorizonCode sun : suns) ++counts_[std::size_t(sun - lowest_ + 1)];
    for (const HorizonCode sun : others) --counts_[std::size_t(sun - lowest_ + 1)];
    for (std::size_t i = 1; i < counts_.size(); ++i) counts_[i] += counts_[i - 1];
    if (std::max(suns.size(), others.size()) <= std::size_t(std::numeric_limits<std::int16_t>::max()))
        short_.assign(counts_.begin(), counts_.end());
}

void HiddenSuns::addTo(const HorizonCode* horizons, std::span<const Stretch> of, std::uint32_t* sums) const {
    const auto add = [&](const auto* counts) {
        const int lowest = lowest_, last = last_;
        for (const auto& [first, end] : of)
            for (std::uint32_t i = first; i < end; ++i)
                sums[i] += std::uint32_t(counts[std::clamp(int(horizons[i]) - lowest, 0, last)]);
    };
    short_.empty() ? add(counts_.data()) : add(short_.data());
}

BinnedSun binnedSun(const SunSteps& sun, double widthDeg, BinDirection direction) {
    const std::vector<Place> places = sortedPlaces(sun, widthDeg);
    BinnedSun binned;
    binned.places.resize(places.size());
    for (std::size_t first = 0; first < places.size();) {
        std::size_t end = first;
        while (end < places.size() && places[end].bin == places[first].bin) ++end;
        const std::span<const Place> ofBin = std::span(places).subspan(first, end - first);
        addBin(binned,
               direction == BinDirection::middle ? middleAway(ofBin.front().bin, widthDeg)
                                                 : meanAway(sun, ofBin),
               ofBin);
        first = end;
    }
    return binned;
}

}  // namespace noonmark
