#include "core/engines/points/sun_bins.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/engines/points/seen_edge.h"

namespace noonmark {

namespace {

struct MonthSun {
    std::uint16_t bin;
    std::uint16_t month;
    float tan;
};

std::vector<MonthSun> sortedSuns(const SunSteps& sun) {
    std::vector<MonthSun> suns;
    suns.reserve(sun.steps.size());
    for (const SunDay& day : sun.days)
        for (std::uint32_t i = day.first; i < day.first + day.count; ++i) {
            const BinnedSun binned = binSun(sun.steps[i]);
            suns.push_back({binned.bin, std::uint16_t(unsigned(day.date.month()) - 1), binned.tan});
        }
    std::ranges::sort(suns, [](const MonthSun& a, const MonthSun& b) {
        return a.bin != b.bin ? a.bin < b.bin : a.tan < b.tan;
    });
    return suns;
}

}  // namespace

BinnedSun binSun(const SunStep& step) {
    const glm::dvec3 direction(step.direction);
    const auto bin = int(azimuthOf(direction) / fullTurn * SunBins::count);
    const double level = std::hypot(direction.x, direction.y);
    return {std::uint16_t(std::min(bin, SunBins::count - 1)), float(direction.z / level)};
}

SunBins::SunBins(const SunSteps& sun) : first_(count + 1) {
    const std::vector<MonthSun> suns = sortedSuns(sun);
    before_.resize(suns.size() + count);
    std::size_t next = 0;
    for (int bin = 0; bin < count; ++bin) {
        first_[std::size_t(bin)] = std::uint32_t(next);
        std::array<std::uint16_t, 12> before{};
        for (; next < suns.size() && suns[next].bin == bin; ++next) {
            before_[next + std::size_t(bin)] = before;
            ++before[suns[next].month];
            tans_.push_back(suns[next].tan);
        }
        before_[next + std::size_t(bin)] = before;
    }
    first_[count] = std::uint32_t(next);
}

void SunBins::addUpTo(int bin, float tan, bool inclusive, int sign, Months& months) const {
    const std::uint32_t first = first_[std::size_t(bin)];
    const std::span<const float> tans(tans_.data() + first, first_[std::size_t(bin) + 1] - first);
    const auto found = inclusive ? std::ranges::upper_bound(tans, tan) : std::ranges::lower_bound(tans, tan);
    const auto& before = before_[first + std::size_t(found - tans.begin()) + std::size_t(bin)];
    for (std::size_t month = 0; month < 12; ++month) months[month] += sign * std::int32_t(before[month]);
}

void SunBins::addAll(int bin, Months& months) const {
    const auto& all = before_[first_[std::size_t(bin) + 1] + std::size_t(bin)];
    for (std::size_t month = 0; month < 12; ++month) months[month] += std::int32_t(all[month]);
}

}  // namespace noonmark
