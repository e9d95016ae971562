#include "core/engines/horizon/geometry/azimuth_bins.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace noonmark {

namespace {

constexpr double slotDeg = 360.0 / BinCuts::slots;
constexpr double degrees = 180 / std::numbers::pi;
constexpr double widestBinDeg = 2;
// What neighbouring bins leave in doubt rays decide (counting/run_decider.h), and the wider the bins, the
// more is left. At steps of a minute, in which the sun moves by a quarter of a degree, a year took least time
// at that width: 1.2 s of processor time for 10,261 receivers in Midtown, 1.28 s at 0.35 deg, 1.53 s at 0.5.
// Longer steps ask for fewer rays.
constexpr double widthOfAPercentDeg = 10, minutesOfFullWidth = 2, narrowest = 0.5;

double widestForRuns(double targetPercent, double stepMinutes) {
    return widthOfAPercentDeg * targetPercent * std::clamp(stepMinutes / minutesOfFullWidth, narrowest, 1.0);
}
constexpr int bandDeg = 10, bands = 9;

// Measured against rays on 800 x 800 m of Midtown, for periods of a week to a year and bins of 0.25 to 2 deg:
// the mean error, in percent of the steps, was 8.4 to 11 times the square root of the sum below, in degrees.
// On single days, whose edges are those of one season, it was 2 to 12 times. On the grid sample the factors
// were 7 and 3 to 10.
double edgesOfACity(std::size_t days) {
    return 11.2 + 0.8 / std::sqrt(double(std::max<std::size_t>(1, days)));
}

/// A range of slots [first, end).
struct Slots {
    int first, end;
};

/// The suns of a period by azimuth, as prefix sums over slots: the number of suns, in total and per altitude
/// band, and the sum of their azimuths.
class SunsByAzimuth {
public:
    explicit SunsByAzimuth(const SunSteps& sun) : before_(BinCuts::slots + 1) {
        std::vector<Place> places(sun.steps.size());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places.size(), 4096), [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) places[i] = placeOf(sun.steps[i]);
        });
        for (const Place& place : places) add(place);
        for (std::size_t slot = 0; slot + 1 < before_.size(); ++slot) before_[slot + 1] += before_[slot];
    }

    [[nodiscard]] double count() const { return before_.back().count; }
    [[nodiscard]] double count(Slots of) const { return at(of.end).count - at(of.first).count; }

    [[nodiscard]] double mean(Slots of) const {
        return (at(of.end).slotSum - at(of.first).slotSum) / std::max(1.0, count(of));
    }

    /// Sum over suns of the distance from their mean, in slots.
    [[nodiscard]] double off(Slots of) const {
        const double middle = mean(of);
        const int split = std::clamp(int(std::ceil(middle)), of.first, of.end);
        const double east = middle * count({of.first, split}) - sumOf({of.first, split});
        return 2 * std::max(0.0, east);
    }

    /// Sum over edge positions and bands of the square of the number of suns on the wrong side; in slots.
    [[nodiscard]] double wrong(Slots of) const {
        const double middle = mean(of);
        double sum = 0;
        for (int edge = of.first + 1; edge < of.end; ++edge)
            sum += squares(edge <= middle ? Slots{of.first, edge} : Slots{edge, of.end});
        return sum;
    }

    /// The first slot, from this one on, with a sun; BinCuts::slots if there is none.
    [[nodiscard]] int nextSun(int slot) const {
        const auto more = std::ranges::upper_bound(before_.begin() + slot + 1, before_.end(), at(slot).count,
                                                   {}, &Before::count);
        return int(more - before_.begin()) - 1;
    }

private:
    struct Before {
        double count = 0, slotSum = 0;
        std::array<float, bands> ofBand{};  // whole numbers, exact up to 16 million
        Before& operator+=(const Before& other) {
            count += other.count;
            slotSum += other.slotSum;
            for (std::size_t band = 0; band < bands; ++band) ofBand[band] += other.ofBand[band];
            return *this;
        }
    };

    struct Place {
        int slot, band;
    };
    static Place placeOf(const SunStep& step) {
        const double altitude = std::asin(std::min(1.0, double(step.direction.z))) * degrees;
        return {findAzimuthSlot(computeAzimuthDeg(step)), std::clamp(int(altitude) / bandDeg, 0, bands - 1)};
    }

    // Counted in the entry after its slot, because sums cover all slots before.
    void add(const Place& place) {
        Before& entry = before_[std::size_t(place.slot) + 1];
        entry.count += 1;
        entry.slotSum += place.slot;
        entry.ofBand[std::size_t(place.band)] += 1;
    }

    [[nodiscard]] const Before& at(int slot) const { return before_[std::size_t(slot)]; }
    [[nodiscard]] double sumOf(Slots of) const { return at(of.end).slotSum - at(of.first).slotSum; }

    [[nodiscard]] double squares(Slots of) const {
        float sum = 0;
        for (std::size_t band = 0; band < bands; ++band) {
            const float suns = at(of.end).ofBand[band] - at(of.first).ofBand[band];
            sum += suns * suns;
        }
        return double(sum);
    }

    std::vector<Before> before_;
};

using Bins = std::vector<Slots>;

// The longest bin that begins at `first`, has at most `widest` slots, and whose suns' distances from their
// mean sum to at most `maxOff`.
Slots binFrom(const SunsByAzimuth& suns, int first, int widest, double maxOff) {
    int end = first + 1, beyond = std::min(first + widest, BinCuts::slots) + 1;
    while (beyond - end > 1) {
        const int middle = (end + beyond) / 2;
        (suns.off({first, middle}) <= maxOff ? end : beyond) = middle;
    }
    return {first, end};
}

Bins binsOf(const SunsByAzimuth& suns, int widest, double maxOff) {
    Bins bins;
    for (int first = suns.nextSun(0); first < BinCuts::slots; first = suns.nextSun(bins.back().end))
        bins.push_back(binFrom(suns, first, widest, maxOff));
    return bins;
}

double expectedPercent(const SunsByAzimuth& suns, const Bins& bins, std::size_t days) {
    double wrong = 0;
    for (const Slots& bin : bins) wrong += suns.wrong(bin);
    return edgesOfACity(days) * std::sqrt(wrong * slotDeg) / std::max(1.0, suns.count());
}

BinCuts cutsOf(const Bins& bins, double widestDeg) {
    BinCuts cuts{std::vector<std::uint16_t>(BinCuts::slots, BinCuts::none), bins.size()};
    for (std::size_t i = 0; i < bins.size(); ++i) {
        const auto [first, end] = bins[i];
        std::fill(cuts.binOfSlot.begin() + first, cuts.binOfSlot.begin() + end, std::uint16_t(i));
        const int next = i + 1 < bins.size() ? bins[i + 1].first : end;
        const double wide = std::min((next - first) * slotDeg, widestDeg);
        cuts.narrowestDeg = i == 0 ? wide : std::min(cuts.narrowestDeg, wide);
        cuts.widestDeg = std::max(cuts.widestDeg, wide);
    }
    return cuts;
}

}  // namespace

double computeAzimuthDeg(const SunStep& step) {
    const double azimuth = std::atan2(double(step.direction.x), double(step.direction.y)) * degrees;
    return azimuth < 0 ? azimuth + 360 : azimuth;
}

int findAzimuthSlot(double azimuthDeg) {
    return std::clamp(int(azimuthDeg / slotDeg), 0, BinCuts::slots - 1);
}

// Bisection on the allowed sum of distances, with which the error grows.
BinCuts chooseBinCuts(const SunSteps& sun, double targetPercent, ShadowCounts counts) {
    constexpr double finest = 1.01;
    const SunsByAzimuth suns(sun);
    const double widestDeg = counts == ShadowCounts::gross
                                 ? widestBinDeg
                                 : std::min(widestBinDeg, widestForRuns(targetPercent, sun.stepMinutes));
    const int widest = std::max(1, int(std::lround(widestDeg / slotDeg)));
    double within = 0, beyond = std::max(1.0, suns.count()) * BinCuts::slots;
    while (beyond > finest * std::max(within, slotDeg)) {
        const double middle = std::sqrt(std::max(within, slotDeg) * beyond);
        const double expected = expectedPercent(suns, binsOf(suns, widest, middle), sun.dayCount());
        (expected <= targetPercent ? within : beyond) = middle;
    }
    return cutsOf(binsOf(suns, widest, within), widestDeg);
}

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
