#include "scenarios/impact/proposal_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "core/describe/text.h"
#include "core/receivers/made_names.h"
#include "core/receivers/rasterize.h"
#include "scenarios/impact/impact_text.h"

namespace noonmark {

namespace {

constexpr float borderM = 50;  // open ground around a building, as around the first region of a city

Box2 boxAround(const std::vector<std::shared_ptr<const Building>>& buildings) {
    Box2 box;
    for (const auto& building : buildings) box.add(bounds(*building));
    return box;
}

bool regionHolds(const Region& region, glm::vec2 point) {
    return std::ranges::any_of(region.polygons,
                               [&](const Footprint& one) { return contains(one, glm::dvec2(point)); });
}

InRegion findInRegion(const Box2& box, const Region& region) {
    const std::array points{box.low, box.high, glm::vec2(box.low.x, box.high.y),
                            glm::vec2(box.high.x, box.low.y), (box.low + box.high) / 2.0F};
    const auto inside =
        std::ranges::count_if(points, [&](glm::vec2 point) { return regionHolds(region, point); });
    if (inside == std::ssize(points)) return InRegion::whole;
    return inside > 0 ? InRegion::part : InRegion::none;
}

// Of shadows at noon: 1 north, -1 south, 0 either.
float findShadowSide(double latDeg) {
    constexpr double tropicDeg = 23.5;
    if (std::abs(latDeg) < tropicDeg) return 0;
    return latDeg > 0 ? 1 : -1;
}

// Of a cell in the region, by the four cells around it.
bool isBesideUnmeasured(const std::vector<bool>& measured, const Grid& grid, int column, int row) {
    if (column == 0 || row == 0 || column + 1 == grid.columns || row + 1 == grid.rows) return true;
    const std::size_t cell = grid.index(column, row), width = std::size_t(grid.columns);
    return !measured[cell - 1] || !measured[cell + 1] || !measured[cell - width] || !measured[cell + width];
}

bool changesAtEdge(const Impact& impact, const Region& region, double thresholdMin) {
    const Grid& grid = impact.grid;
    std::vector<bool> measured(grid.size());
    for (const std::uint32_t cell : collectCells(region.polygons, grid)) measured[cell] = true;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const std::size_t cell = grid.index(column, row);
            const bool changes = std::abs(double(impact.grossMin[cell])) > thresholdMin;  // NaN: no receiver
            if (changes && isBesideUnmeasured(measured, grid, column, row)) return true;
        }
    return false;
}

}  // namespace

InRegion findInRegion(const std::vector<std::shared_ptr<const Building>>& buildings, const Region& region) {
    std::size_t whole = 0, none = 0;
    for (const auto& building : buildings) {
        const InRegion one = findInRegion(bounds(*building), region);
        if (one == InRegion::whole) ++whole;
        if (one == InRegion::none) ++none;
    }
    if (whole == buildings.size()) return InRegion::whole;
    return none == buildings.size() ? InRegion::none : InRegion::part;
}

Region makeRegionAround(const std::vector<std::shared_ptr<const Building>>& buildings, const Region& region,
                        double latDeg) {
    const Box2 box = boxAround(buildings), before = bounds(region);
    glm::vec2 size = box.high - box.low + 2 * borderM;
    if (!before.empty()) size = glm::max(size, before.high - before.low);
    glm::vec2 middle = (box.low + box.high) / 2.0F;
    middle.y += findShadowSide(latDeg) * ((size.y - (box.high.y - box.low.y)) / 2 - borderM) / 2;
    Region around = makeRegionFromLocalBox({middle - size / 2.0F, middle + size / 2.0F});
    const Building& first = *buildings.front();
    around.name = makeName(madeNames::around, {first.name.empty() ? first.sourceId : first.name});
    return around;
}

BeyondRegion findBeyond(const ImpactAnswer& answer) {
    if (answer.beyond) return *answer.beyond;
    const Region& region = answer.settings.study.region;
    return {findInRegion(answer.proposal.buildings, region),
            changesAtEdge(answer.study.total, region, answer.settings.thresholdsMin.front())};
}

std::optional<Sentence> describeBeyond(const ImpactAnswer& answer) {
    const double thresholdMin = answer.settings.thresholdsMin.front();
    const BeyondRegion beyond = findBeyond(answer);
    if (beyond.proposal == InRegion::none)
        return Sentence{NM_TEXT("What %1 builds stands outside the region: the figures are of the shadow "
                                "that reaches into it."),
                        {answer.to}};
    if (beyond.proposal == InRegion::part)
        return Sentence{NM_TEXT("A part of what %1 builds stands outside the region: the figures are of "
                                "the shadow in it."),
                        {answer.to}};
    if (!beyond.changesAtEdge) return std::nullopt;
    return Sentence{
        NM_TEXT("The change by more than %1 a day reaches the region's edge: beyond it is not measured."),
        {Amount{thresholdMin, FigureUnit::minutes}}};
}

}  // namespace noonmark
