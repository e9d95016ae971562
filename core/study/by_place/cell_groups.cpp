#include "core/study/by_place/cell_groups.h"

#include <map>
#include <numeric>
#include <utility>

#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

/// What cells are placed for.
struct Placing {
    std::span<const City* const> cities;
    const std::vector<Place>& places;
    const SunByPlaceSettings& settings;
    const std::stop_token& stop;
};

std::vector<CountedCell> listCells(const PlaceReceivers& on, std::size_t place) {
    std::vector<CountedCell> cells;
    auto uneven = on.unevenOf[place].begin();
    for (const CellSpan& span : on.cellsOf[place])
        for (std::uint32_t i = 0; i < span.count; ++i) {
            CountedCell one{on.receivers.cells[span.first + i], span.first + i};
            if (uneven != on.unevenOf[place].end() && uneven->bit == cells.size()) {
                one.share += uneven->extra;
                one.isInside = !uneven->isBeside;
                ++uneven;
            }
            cells.push_back(one);
        }
    return cells;
}

Result<CellGroup> placeGroup(const Placing& on, std::vector<std::size_t> which, double cellM) {
    std::vector<Place> places;
    for (const std::size_t i : which) places.push_back(on.places[i]);
    auto receivers = placeReceiversOnPlaces(on.cities, places, {.cellM = cellM}, on.stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    CellGroup group{std::move(which), *std::move(receivers), {}};
    for (std::size_t i = 0; i < places.size(); ++i) group.cells.push_back(listCells(group.on, i));
    return group;
}

Result<CellGroup> placeAll(const Placing& on) {
    std::vector<std::size_t> all(on.places.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return placeGroup(on, std::move(all), on.settings.study.receivers.cellM);
}

double countCells(const std::vector<CountedCell>& cells) {
    double sum = 0;
    for (const CountedCell& one : cells) sum += one.share;
    return sum;
}

// Small places, those in one square together: a fine grid over a whole city would be too large, and each
// square takes its own walls of buildings.
std::map<std::pair<int, int>, std::vector<std::size_t>> listSmall(const Placing& on, const CellGroup& all) {
    constexpr double cellsOfSide = 6000;
    const auto squareM = float(cellsOfSide * on.settings.smallCellM);
    std::map<std::pair<int, int>, std::vector<std::size_t>> small;
    if (on.settings.smallCellM >= on.settings.study.receivers.cellM) return small;
    for (std::size_t i = 0; i < on.places.size(); ++i) {
        if (countCells(all.cells[i]) >= SunByPlaceSettings::smallPlaceCells) continue;
        const Box2 box = bounds(on.places[i]);
        const glm::vec2 square = glm::floor((box.low + box.high) / 2.0F / squareM);
        small[{int(square.x), int(square.y)}].push_back(i);
    }
    return small;
}

// They keep what the larger cells find of them.
void leaveOutPlacesWithoutCells(CellGroup& group) {
    for (std::size_t i = group.places.size(); i-- > 0;) {
        if (!group.cells[i].empty()) continue;
        group.places.erase(group.places.begin() + std::ptrdiff_t(i));
        group.cells.erase(group.cells.begin() + std::ptrdiff_t(i));
    }
}

Result<std::vector<CellGroup>> placeSmall(const Placing& on, const CellGroup& all) {
    std::vector<CellGroup> groups;
    for (auto& [square, which] : listSmall(on, all)) {
        auto group = placeGroup(on, std::move(which), on.settings.smallCellM);
        if (!group) return tl::make_unexpected(group.error());
        leaveOutPlacesWithoutCells(*group);
        if (!group->places.empty()) groups.push_back(*std::move(group));
    }
    return groups;
}

}  // namespace

Result<PlaceCells> placeCells(std::span<const City* const> cities, const std::vector<Place>& places,
                              const SunByPlaceSettings& settings, const std::stop_token& stop) {
    const Placing on{cities, places, settings, stop};
    auto all = placeAll(on);
    if (!all) return tl::make_unexpected(all.error());
    auto small = placeSmall(on, *all);
    if (!small) return tl::make_unexpected(small.error());
    return PlaceCells{*std::move(all), *std::move(small)};
}

}  // namespace noonmark
