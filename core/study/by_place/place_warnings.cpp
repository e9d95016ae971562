#include "core/study/by_place/place_warnings.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/city/map_context.h"
#include "core/city/terrain/post_grid.h"
#include "core/city/trees/tree.h"
#include "core/measures/place_cells.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

bool isBuiltOver(std::span<const City* const> cities, const Place& place) {
    constexpr double nothingM2 = 0.01;
    const auto built = findBuiltGround(cities, std::span(&place, 1));
    double openM2 = 0;
    for (const Footprint& polygon : findOpenGround(place, built.front())) openM2 += area(polygon);
    return openM2 < nothingM2;
}

// They stay in the tables, without figures.
void listPlacesWithoutCells(std::span<const City* const> cities, std::vector<SunByPlace>& all) {
    SunByPlace& baseline = all.front();
    for (std::size_t i = 0; i < baseline.places.size(); ++i) {
        if (baseline.sun[i].cells > 0) continue;
        const Place& place = baseline.places[i];
        const auto why = isBuiltOver(cities, place) ? NoSunFigures::builtOver : NoSunFigures::betweenCells;
        for (SunByPlace& made : all) made.sun[i].why = why;
        baseline.warnings.push_back(
            {WarningKind::leftOut, fmt::format("a place without figures: {}", describe(why)), place.name});
    }
}

// In the tables of all cities, and once as a warning.
void remark(std::vector<SunByPlace>& all, std::size_t place, PlaceRemark remark) {
    for (SunByPlace& made : all) made.sun[place].remarks.push_back(remark);
    const auto choices = placeRemarkChoices();
    const auto choice = std::ranges::find(choices, remark, &Choice<PlaceRemark>::value);
    all.front().warnings.push_back(
        {WarningKind::assumed, fmt::format("a place {}", choice->label), all.front().places[place].name});
}

bool isBeyond(const Terrain& terrain, const Place& place, const Grid& grid,
              const std::vector<CountedCell>& cells) {
    const auto columns = std::uint32_t(grid.columns);
    const auto isCellBeyond = [&](const CountedCell& one) {
        return beyondM(terrain.grid, grid.centre(int(one.cell % columns), int(one.cell / columns))) > 0;
    };
    const Box2 box = bounds(place);
    if (cells.empty()) return beyondM(terrain.grid, glm::dvec2(box.low + box.high) / 2.0) > 0;
    return std::ranges::any_of(cells, isCellBeyond);
}

void listPlacesBeyondTerrain(std::vector<SunByPlace>& all, const CellGroup& group) {
    const auto& terrain = all.front().city.terrain;
    if (!terrain) return;
    for (std::size_t i = 0; i < group.cells.size(); ++i)
        if (isBeyond(*terrain, all.front().places[i], group.on.receivers.grid, group.cells[i]))
            remark(all, i, PlaceRemark::beyondTerrain);
}

// They are measured all the same: a lake may be the place that matters.
Result<void> listPlacesOnWater(std::vector<SunByPlace>& made, const CellGroup& all,
                               const std::stop_token& stop) {
    const SunByPlace& baseline = made.front();
    const auto& map = baseline.city.context;
    if (!map || std::ranges::none_of(map->areas,
                                     [](const ContextArea& area) { return area.kind == ContextKind::water; }))
        return {};
    const auto dry =
        placeReceiversInPart(baseline.city, baseline.settings.study.region, all.on.receivers.grid, stop);
    if (!dry) return tl::make_unexpected(dry.error());
    for (std::size_t i = 0; i < all.cells.size(); ++i) {
        const auto wet = std::ranges::count_if(
            all.cells[i], [&](const CountedCell& one) { return dry->kind[one.cell] == CellKind::water; });
        if (2 * std::size_t(wet) > all.cells[i].size()) remark(made, i, PlaceRemark::onWater);
    }
    return {};
}

}  // namespace

Result<void> warnOfPlaces(std::span<const City* const> cities, std::vector<SunByPlace>& made,
                          const CellGroup& all, const std::stop_token& stop) {
    std::ranges::move(warnOfTrees(cities.front()->trees), std::back_inserter(made.front().warnings));
    listPlacesWithoutCells(cities, made);
    listPlacesBeyondTerrain(made, all);
    return listPlacesOnWater(made, all, stop);
}

}  // namespace noonmark
