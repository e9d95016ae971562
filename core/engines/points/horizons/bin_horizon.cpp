#include "core/engines/points/horizons/bin_horizon.h"

#include <cmath>
#include <span>

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
            const SunInBin binned = binSun(sun.steps[i]);
            suns.push_back({binned.bin, std::uint16_t(unsigned(day.date.month()) - 1), binned.tan});
        }
    std::ranges::sort(suns, [](const MonthSun& a, const MonthSun& b) {
        return a.bin != b.bin ? a.bin < b.bin : a.tan < b.tan;
    });
    return suns;
}

void fillBlock(std::vector<float>& list) {
    const std::size_t whole = (list.size() / SunBins::blockSize + 1) * SunBins::blockSize;
    list.resize(whole, std::numeric_limits<float>::infinity());
}

void addTans(std::span<const MonthSun> suns, SunBins& bins) {
    const std::size_t first = bins.tans.size();
    for (const MonthSun& sun : suns) bins.tans.push_back(sun.tan);
    fillBlock(bins.tans);
    for (std::size_t i = first; i < bins.tans.size(); i += SunBins::blockSize)
        bins.lastOfBlock.push_back(bins.tans[i + SunBins::blockSize - 1]);
    fillBlock(bins.lastOfBlock);
}

void addRows(std::span<const MonthSun> suns, SunBins& bins) {
    std::array<std::uint16_t, SunBins::months> above{};
    for (const MonthSun& sun : suns) ++above[sun.month];
    bins.above.insert(bins.above.end(), above.begin(), above.end());
    for (const MonthSun& sun : suns) {
        --above[sun.month];
        bins.above.insert(bins.above.end(), above.begin(), above.end());
    }
}

}  // namespace

SunInBin binSun(const SunStep& step) {
    const glm::dvec3 direction(step.direction);
    const auto bin = int(azimuthOf(direction) / fullTurn * SunBins::count);
    const double level = std::hypot(direction.x, direction.y);
    return {std::uint16_t(std::min(bin, SunBins::count - 1)), float(direction.z / level)};
}

SunBins::SunBins(const SunSteps& sun) {
    const std::vector<MonthSun> suns = sortedSuns(sun);
    auto first = suns.begin();
    for (int bin = 0; bin < count; ++bin) {
        const auto end = std::find_if(first, suns.end(), [&](const MonthSun& s) { return s.bin != bin; });
        const std::span its(first, end);
        bins.push_back({.firstTan = std::uint32_t(tans.size()),
                        .firstLast = std::uint32_t(lastOfBlock.size()),
                        .firstRow = std::uint32_t(above.size() / months),
                        .suns = std::uint32_t(its.size()),
                        .highestTan = its.empty() ? 0 : its.back().tan});
        addTans(its, *this);
        addRows(its, *this);
        first = end;
    }
    above.resize(above.size() + blockSize);
}

BinDirections::BinDirections(const SunBins& suns) {
    for (int bin = 0; bin < SunBins::count; ++bin) {
        const auto k = std::size_t(bin);
        exactSine[k] = std::sin((bin + 0.5) * fullTurn / SunBins::count);
        exactCosine[k] = std::cos((bin + 0.5) * fullTurn / SunBins::count);
        sine[k] = float(exactSine[k]);
        cosine[k] = float(exactCosine[k]);
        highestTan[k] = suns.bins[k].highestTan;
    }
}

}  // namespace noonmark
