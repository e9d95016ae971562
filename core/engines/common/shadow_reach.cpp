#include "core/engines/common/shadow_reach.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/city/trees/tree.h"

namespace noonmark {

namespace {

constexpr int reachBinCount = 360;
constexpr double binWidth = 2 * std::numbers::pi / reachBinCount;
constexpr double marginM = 1;  // exceeds any rounding of coordinates

int binOf(glm::vec3 towardsSun) {
    const double azimuth = std::atan2(double(towardsSun.x), double(towardsSun.y));
    return std::clamp(int((azimuth + std::numbers::pi) / binWidth), 0, reachBinCount - 1);
}

glm::dvec2 awayFromSun(int bin) {
    const double azimuth = (bin + 0.5) * binWidth - std::numbers::pi;
    return {-std::sin(azimuth), -std::cos(azimuth)};
}

// Narrows [from, to], a section of the line t x direction, to where this coordinate lies in [low, high].
void clip(double direction, double low, double high, double& from, double& to) {
    if (direction == 0) {
        if (low > 0 || high < 0) to = from - 1;
        return;
    }
    const double atLow = low / direction, atHigh = high / direction;
    from = std::max(from, std::min(atLow, atHigh));
    to = std::min(to, std::max(atLow, atHigh));
}

struct LowestGround {
    Box2 box;
    float groundM = 0;
};

// Works on integer cell indices first, because a large region has tens of millions of cells.
LowestGround lowestGround(const Receivers& receivers) {
    if (receivers.cells.empty()) return {};
    const Grid& grid = receivers.grid;
    const auto columns = std::uint32_t(grid.columns);
    std::uint32_t west = columns, east = 0;
    for (const std::uint32_t cell : receivers.cells) {
        west = std::min(west, cell % columns);
        east = std::max(east, cell % columns);
    }
    LowestGround lowest;
    lowest.box.add(glm::vec2(grid.centre(int(west), int(receivers.cells.front() / columns))));
    lowest.box.add(glm::vec2(grid.centre(int(east), int(receivers.cells.back() / columns))));
    lowest.groundM = float(lowestGroundM(receivers));
    return lowest;
}

}  // namespace

ShadowReach::ShadowReach(const SunSteps& sun) {
    std::array<double, reachBinCount> longest;
    longest.fill(-1);
    for (const SunStep& step : sun.steps) {
        const double horizontal = std::hypot(double(step.direction.x), double(step.direction.y));
        double& bin = longest[std::size_t(binOf(step.direction))];
        bin = std::max(bin, horizontal / std::max(double(step.direction.z), 1e-9));
    }
    for (int bin = 0; bin < reachBinCount; ++bin)
        if (longest[std::size_t(bin)] >= 0) bins_.push_back({awayFromSun(bin), longest[std::size_t(bin)]});
    for (const Bin& bin : bins_) longest_ = std::max(longest_, bin.lengthPerMetre);
}

// The shadow of the box is the box moved along a displacement segment that starts at 0. It touches the
// receivers' box where that segment meets the box of all differences between points of the two boxes.
bool ShadowReach::touches(const Box2& box, double heightM, const Box2& receivers) const {
    if (heightM <= 0 || box.empty() || receivers.empty()) return false;
    const glm::dvec2 low = glm::dvec2(receivers.low) - glm::dvec2(box.high);
    const glm::dvec2 high = glm::dvec2(receivers.high) - glm::dvec2(box.low);
    const glm::dvec2 nearest = glm::max(glm::dvec2(0), glm::max(low, -high));
    const double farthest = marginM + heightM * longest_ * (1 + binWidth);
    if (glm::dot(nearest, nearest) > farthest * farthest) return false;  // excludes most of a large city
    return std::any_of(bins_.begin(), bins_.end(), [&](const Bin& bin) {
        const double length = heightM * bin.lengthPerMetre;
        const double aside = marginM + length * binWidth / 2;
        double from = 0, to = length;
        clip(bin.away.x, low.x - aside, high.x + aside, from, to);
        clip(bin.away.y, low.y - aside, high.y + aside, from, to);
        return from <= to;
    });
}

std::vector<std::uint32_t> findBuildingsInReach(const City& city, const Receivers& receivers,
                                                const SunSteps& sun) {
    const ShadowReach reach(sun);
    const LowestGround lowest = lowestGround(receivers);
    std::vector<std::uint8_t> touches(city.buildings.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, touches.size(), 1024), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const Building& building = *city.buildings[i];
            const double heightM = double(topM(building)) - double(lowest.groundM);
            touches[i] = reach.touches(bounds(building), heightM, lowest.box) ? 1 : 0;
        }
    });
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < touches.size(); ++i)
        if (touches[i] != 0) indices.push_back(i);
    return indices;
}

std::vector<std::uint32_t> findBuildingsInReach(const City& city, const Receivers& receivers,
                                                const SunSteps& sun, Cost& cost) {
    std::vector<std::uint32_t> used = findBuildingsInReach(city, receivers, sun);
    countInReach(cost, used.size(), city.buildings.size());
    return used;
}

std::vector<std::uint32_t> findTreesInReach(const City& city, const Receivers& receivers,
                                            const SunSteps& sun) {
    if (!city.trees || !city.trees->weighed || receivers.cells.empty()) return {};
    const LowestGround lowest = lowestGround(receivers);
    return findTreesInReach(city, lowest.box, lowest.groundM, sun);
}

std::vector<std::uint32_t> findTreesInReach(const City& city, const Box2& receivers, float lowestM,
                                            const SunSteps& sun) {
    std::vector<std::uint32_t> indices;
    if (!city.trees || !city.trees->weighed || receivers.empty()) return indices;
    const ShadowReach reach(sun);
    for (std::uint32_t i = 0; i < city.trees->trees.size(); ++i) {
        const Tree& tree = city.trees->trees[i];
        const glm::vec2 place(tree.place), half(tree.crownDiameterM / 2);
        Box2 box;
        box.add(place - half);
        box.add(place + half);
        const double heightM = double(tree.groundM) + double(tree.heightM) - double(lowestM);
        if (reach.touches(box, heightM, receivers)) indices.push_back(i);
    }
    return indices;
}

void countInReach(Cost& cost, std::size_t used, std::size_t all) {
    cost.buildingsUsed = std::uint32_t(used);
    cost.skipped[buildingsOutOfReach] = all - used;
}

namespace {

constexpr int side = 32;

Box2 computeBox(const Grid& grid, int column, int row) {
    const auto along = [&](double fromM, int cells) { return float(fromM + cells * grid.cellM); };
    return {{along(grid.westM, column), along(grid.southM, row)},
            {along(grid.westM, std::min(column + side, grid.columns)),
             along(grid.southM, std::min(row + side, grid.rows))}};
}

void leaveOut(Receivers& receivers, int firstColumn, int firstRow) {
    const Grid& grid = receivers.grid;
    for (int row = firstRow; row < std::min(firstRow + side, grid.rows); ++row)
        for (int column = firstColumn; column < std::min(firstColumn + side, grid.columns); ++column)
            receivers.kind[grid.index(column, row)] = CellKind::outside;
}

}  // namespace

Receivers findReached(const Buildings& buildings, const Receivers& receivers, const ShadowReach& reach) {
    Receivers reached = receivers;
    const double groundM = lowestGroundM(receivers);
    const auto touchedByAny = [&](const Box2& tile) {
        return std::ranges::any_of(buildings, [&](const auto& building) {
            return reach.touches(bounds(*building), double(topM(*building)) - groundM, tile);
        });
    };
    for (int row = 0; row < receivers.grid.rows; row += side)
        for (int column = 0; column < receivers.grid.columns; column += side)
            if (!touchedByAny(computeBox(receivers.grid, column, row))) leaveOut(reached, column, row);
    std::erase_if(reached.cells, [&](std::uint32_t cell) { return reached.kind[cell] == CellKind::outside; });
    return reached;
}

void fillUnreached(ShadowField& without, const ShadowField& with, const Receivers& receivers) {
    for (const std::uint32_t cell : receivers.cells) {
        if (!std::isnan(without.grossMin[cell])) continue;
        without.grossMin[cell] = with.grossMin[cell];
        without.continuousMin[cell] = with.continuousMin[cell];
    }
}

}  // namespace noonmark
