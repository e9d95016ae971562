#include "core/lab/bench/contests/site.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numeric>
#include <random>

#include "core/city/city_position.h"
#include "core/engines/common/receiver_tiles.h"

namespace noonmark::bench {

namespace {

// std::uniform_int_distribution differs between libraries; this function does not.
std::size_t anyOf(std::mt19937& random, std::size_t count) { return std::size_t(random()) % count; }

void shuffle(std::vector<std::size_t>& values, std::mt19937& random) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[anyOf(random, i)]);
}

Region squareAround(glm::vec2 centre, const Box2& city, double sideM) {
    const glm::vec2 half =
        glm::min(glm::max((city.high - city.low) / 2.0F, glm::vec2(1)), glm::vec2(float(sideM / 2)));
    centre = glm::clamp(centre, city.low + half, glm::max(city.low + half, city.high - half));
    return makeRegionFromLocalBox({centre - half, centre + half});
}

Result<SunSteps> computeSunOver(const BenchSite& site, Period period) {
    period.zone = site.zone;
    const Box2 box = bounds(site.city);
    return computeSunSteps(period, placeObserver(site.city, glm::dvec2(box.low + box.high) / 2.0));
}

}  // namespace

Region pickMiddleSquare(const City& city, double sideM) {
    const Box2 box = bounds(city);
    return squareAround((box.low + box.high) / 2.0F, box, sideM);
}

std::vector<Region> pickRandomSquares(const BenchSite& site, int count) {
    std::mt19937 random(site.seed);
    const Box2 box = bounds(site.city);
    std::vector<Region> squares;
    for (int i = 0; i < count; ++i) {
        const Building& building = *site.city.buildings[anyOf(random, site.city.buildings.size())];
        const Box2 around = bounds(building);
        squares.push_back(squareAround((around.low + around.high) / 2.0F, box, site.sideM));
    }
    return squares;
}

std::vector<CivilDate> pickRandomDays(const BenchSite& site, int count) {
    std::mt19937 random(site.seed);
    const std::chrono::sys_days first = site.date.year() / std::chrono::January / 1;
    std::vector<std::size_t> days(365);
    std::iota(days.begin(), days.end(), std::size_t{0});
    shuffle(days, random);
    days.resize(std::size_t(std::clamp(count, 0, 365)));
    std::ranges::sort(days);
    std::vector<CivilDate> dates;
    for (const std::size_t day : days) dates.emplace_back(first + std::chrono::days(day));
    return dates;
}

Result<SunSteps> computeSunOver(const BenchSite& site, CivilDate start, int days, double hours) {
    const auto from = std::chrono::minutes(int(60 * (12 - hours / 2)));
    return computeSunOver(site, Period{.start = start, .days = days, .from = from, .hours = hours});
}

Result<SunSteps> computeYearSun(const BenchSite& site, double hours) {
    return computeSunOver(site, site.date.year() / std::chrono::January / 1, 365, hours);
}

Result<SunSteps> makeNoonHour(const BenchSite& site) {
    return computeSunOver(site, Period{.start = site.date, .from = std::chrono::hours(12), .hours = 1});
}

Result<SunSteps> daylightOf(const BenchSite& site, CivilDate date) {
    return computeSunOver(site, Period{.start = date, .window = SolarHours{}});
}

SunSteps sliceSteps(const SunSteps& sun, std::size_t first, std::size_t count) {
    SunSteps stretch;
    stretch.stepMinutes = sun.stepMinutes;
    stretch.steps.assign(sun.steps.begin() + std::ptrdiff_t(first),
                         sun.steps.begin() + std::ptrdiff_t(first + count));
    stretch.days.push_back({.count = std::uint32_t(count)});
    return stretch;
}

std::vector<int> chooseResolutions(const BenchSite& site, std::vector<int> cellsASide) {
    std::erase_if(cellsASide, [&](int cells) {
        const double cellM = site.sideM / cells;
        return cellM < ReceiverSettings::minCellM || cellM > ReceiverSettings::maxCellM;
    });
    return cellsASide;
}

Result<Receivers> placeReceiversAt(const BenchSite& site, int cellsASide, const std::stop_token& stop) {
    return placeReceiversOnGround(site.city, pickMiddleSquare(site.city, site.sideM),
                                  {site.sideM / cellsASide}, stop);
}

Result<Receivers> pickMiddleReceivers(const BenchSite& site, const std::stop_token& stop) {
    return placeReceiversOnGround(site.city, pickMiddleSquare(site.city, site.sideM), {}, stop);
}

Receivers sampleOf(const Receivers& receivers, std::size_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    const ReceiverTiles tiles(receivers);
    std::vector<std::size_t> order(tiles.count());
    std::iota(order.begin(), order.end(), std::size_t{0});
    shuffle(order, random);
    Receivers sample = receivers;
    sample.cells.clear();
    std::vector<std::uint32_t> cells;
    for (std::size_t i = 0; i < order.size() && sample.cells.size() < count; ++i) {
        tiles.cellsOf(order[i], cells);
        sample.cells.insert(sample.cells.end(), cells.begin(), cells.end());
    }
    std::ranges::sort(sample.cells);
    for (const std::uint32_t cell : receivers.cells)
        if (!std::ranges::binary_search(sample.cells, cell)) sample.kind[cell] = CellKind::outside;
    return sample;
}

}  // namespace noonmark::bench
