#include "core/engines/horizon/geometry/azimuth_bins.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

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

// Directions have length 1, so nothing overflows.
double acrossOf(glm::vec3 direction) {
    const double x = double(direction.x), y = double(direction.y);
    return std::sqrt(x * x + y * y);
}

HorizonCode codeOf(const SunStep& step) {
    const double across = acrossOf(step.direction);
    return toSunCode(double(step.direction.z) / std::max(across, 1e-9));
}

template <class NumberOf>
std::vector<Place> placesOf(const SunSteps& sun, const NumberOf& numberOf) {
    std::vector<Place> places(sun.steps.size());
    tbb::parallel_for(
        tbb::blocked_range<std::uint32_t>(0, std::uint32_t(places.size()), 4096), [&](const auto& range) {
            for (std::uint32_t i = range.begin(); i < range.end(); ++i)
                places[i] = {i, numberOf(computeAzimuthDeg(sun.steps[i])), codeOf(sun.steps[i])};
        });
    return places;
}

/// Places sorted by bin, and by time within a bin.
struct BinPlaces {
    std::vector<Place> places;
    std::vector<std::size_t> ends;  ///< for each bin number, and one more
};

// A counting sort.
template <class NumberOf>
BinPlaces sortedPlaces(const SunSteps& sun, const NumberOf& numberOf) {
    const std::vector<Place> inTime = placesOf(sun, numberOf);
    BinPlaces sorted{std::vector<Place>(inTime.size()), {0, 0}};
    for (const Place& place : inTime) {
        if (place.bin + 2 >= sorted.ends.size()) sorted.ends.resize(place.bin + 3);
        ++sorted.ends[place.bin + 2];
    }
    for (std::size_t i = 2; i < sorted.ends.size(); ++i) sorted.ends[i] += sorted.ends[i - 1];
    for (const Place& place : inTime) sorted.places[sorted.ends[place.bin + 1]++] = place;
    return sorted;
}

// Mean of the steps' horizontal directions, each normalised.
glm::dvec2 meanAway(const SunSteps& sun, std::span<const Place> places) {
    glm::dvec2 sum(0);
    for (const Place& place : places) {
        const glm::vec3 towards = sun.steps[place.step].direction;
        const double length = acrossOf(towards);
        if (length > 0) sum -= glm::dvec2(double(towards.x), double(towards.y)) / length;
    }
    const double length = std::hypot(sum.x, sum.y);
    return length > 0 ? sum / length : glm::dvec2(0, 1);  // a sun in the zenith has no azimuth
}

using PlacesOfBin = std::span<const Place>;

std::vector<PlacesOfBin> binsOf(const BinPlaces& sorted) {
    std::vector<PlacesOfBin> bins;
    for (std::size_t i = 1; i < sorted.ends.size(); ++i)
        if (sorted.ends[i] > sorted.ends[i - 1])
            bins.push_back(
                std::span(sorted.places).subspan(sorted.ends[i - 1], sorted.ends[i] - sorted.ends[i - 1]));
    return bins;
}

template <class NumberOf, class AwayOf>
BinnedSun binnedBy(const SunSteps& sun, const NumberOf& numberOf, const AwayOf& awayOf) {
    const BinPlaces sorted = sortedPlaces(sun, numberOf);
    const std::vector<PlacesOfBin> bins = binsOf(sorted);
    BinnedSun binned;
    binned.places.resize(sorted.places.size());
    binned.bins.resize(bins.size());
    tbb::parallel_for(std::size_t{0}, bins.size(), [&](std::size_t i) {
        AzimuthBin& bin = binned.bins[i];
        bin = {bins[i].front().bin, awayOf(bins[i]), std::vector<HorizonCode>(bins[i].size())};
        std::ranges::transform(bins[i], bin.suns.begin(), &Place::sun);
        std::ranges::sort(bin.suns);
        for (const Place& place : bins[i]) binned.places[place.step] = {std::uint16_t(i), place.sun};
    });
    return binned;
}

}  // namespace

glm::dvec2 computeMiddleDirection(std::uint32_t bin, double widthDeg) {
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
    for (const HorizonCode sun : suns) ++counts_[std::size_t(sun - lowest_) + 1];
    for (const HorizonCode sun : others) --counts_[std::size_t(sun - lowest_) + 1];
    for (std::size_t i = 1; i < counts_.size(); ++i) counts_[i] += counts_[i - 1];
}

BinnedSun binSun(const SunSteps& sun, double widthDeg, BinDirection direction) {
    const auto numberOf = [&](double azimuthDeg) { return std::uint32_t(azimuthDeg / widthDeg); };
    const auto awayOf = [&](std::span<const Place> places) {
        return direction == BinDirection::middle ? computeMiddleDirection(places.front().bin, widthDeg)
                                                 : meanAway(sun, places);
    };
    BinnedSun binned = binnedBy(sun, numberOf, awayOf);
    binned.narrowestDeg = binned.widestDeg = widthDeg;
    return binned;
}

BinnedSun binSun(const SunSteps& sun, const BinCuts& cuts) {
    const auto numberOf = [&](double azimuthDeg) {
        return std::uint32_t(cuts.binOfSlot[std::size_t(findAzimuthSlot(azimuthDeg))]);
    };
    BinnedSun binned =
        binnedBy(sun, numberOf, [&](std::span<const Place> places) { return meanAway(sun, places); });
    binned.narrowestDeg = cuts.narrowestDeg;
    binned.widestDeg = cuts.widestDeg;
    return binned;
}

BinnedSun binSun(const SunSteps& sun, const HorizonSweepSettings& settings) {
    if (settings.binDeg > 0) return binSun(sun, settings.binDeg);
    return binSun(sun, chooseBinCuts(sun, settings.errorTargetPercent, settings.counts));
}

std::size_t binCount(const SunSteps& sun, const HorizonSweepSettings& settings) {
    if (settings.binDeg <= 0) return chooseBinCuts(sun, settings.errorTargetPercent, settings.counts).bins;
    std::vector<std::uint8_t> visited(std::size_t(360 / settings.binDeg) + 2);
    for (const SunStep& step : sun.steps) visited[std::size_t(computeAzimuthDeg(step) / settings.binDeg)] = 1;
    return std::size_t(std::ranges::count(visited, 1));
}

std::string formatText(const BinnedSun& binned) {
    const std::string narrowest = fmt::format("{:.2g}", binned.narrowestDeg),
                      widest = fmt::format("{:.2g}", binned.widestDeg);
    return fmt::format("{} azimuth bins of {}{}{} deg", binned.bins.size(), narrowest,
                       narrowest == widest ? "" : " to ", narrowest == widest ? "" : widest);
}

}  // namespace noonmark
