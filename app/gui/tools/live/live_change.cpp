#include "app/gui/tools/live/live_change.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/receivers/place_names.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

constexpr float notMeasured = std::numeric_limits<float>::quiet_NaN();

// Where one of the cities has a roof, the difference of two surfaces would be no change of shadow.
void keepOpenGround(const Receivers& before, const Receivers& after, Impact& impact) {
    for (std::size_t cell = 0; cell < impact.grossMin.size(); ++cell)
        if (before.kind[cell] != CellKind::ground || after.kind[cell] != CellKind::ground)
            impact.grossMin[cell] = impact.continuousMin[cell] = notMeasured;
}

std::optional<std::uint32_t> findWorst(const Impact& impact) {
    std::optional<std::uint32_t> worst;
    auto maximum = float(noChangeMin);
    for (std::size_t cell = 0; cell < impact.grossMin.size(); ++cell)
        if (impact.grossMin[cell] > maximum) {
            maximum = impact.grossMin[cell];
            worst = std::uint32_t(cell);
        }
    return worst;
}

// Whether a cell lies at the edge of the grid or of the region in it.
bool isAtEdge(const Receivers& receivers, int column, int row) {
    const Grid& grid = receivers.grid;
    if (column == 0 || row == 0 || column + 1 == grid.columns || row + 1 == grid.rows) return true;
    const std::size_t cell = grid.index(column, row), above = cell + std::size_t(grid.columns),
                      below = cell - std::size_t(grid.columns);
    return std::ranges::any_of(std::array{cell - 1, cell + 1, above, below}, [&](std::size_t beside) {
        return receivers.kind[beside] == CellKind::outside;
    });
}

bool changesAtEdge(const Receivers& receivers, const Impact& impact) {
    for (int row = 0; row < impact.grid.rows; ++row)
        for (int column = 0; column < impact.grid.columns; ++column) {
            const float change = std::abs(impact.grossMin[impact.grid.index(column, row)]);
            if (change > float(noChangeMin) && isAtEdge(receivers, column, row)) return true;
        }
    return false;
}

std::vector<PlaceChange> measurePlaces(const Impact& impact, const std::vector<GridPlace>& places) {
    std::vector<PlaceChange> changes;
    for (const GridPlace& place : places) {
        PlaceChange change{place.name, place.whole,
                           computeFigures(impact, place.cells, defaultThresholdsMin.front())};
        if (change.figures.gross.anyMoreShadowM2 > 0) changes.push_back(std::move(change));
    }
    std::ranges::stable_sort(changes, std::greater(), [](const PlaceChange& one) {
        return std::tuple(one.figures.gross.moreShadowM2, one.figures.gross.maxMoreShadowMin);
    });
    return changes;
}

bool isInside(const Box2& box, const Grid& grid) {
    return double(box.low.x) >= grid.westM && double(box.low.y) >= grid.southM &&
           double(box.high.x) <= grid.eastM() && double(box.high.y) <= grid.northM();
}

}  // namespace

std::vector<GridPlace> findPlaceCells(const std::vector<Place>& places, const Grid& grid) {
    std::vector<GridPlace> found;
    for (const Place& place : places) {
        const Box2 box = bounds(place);
        if (!overlaps(box, grid)) continue;
        GridPlace cells{place.name, collectCells(place.polygons, grid), isInside(box, grid)};
        if (!cells.cells.empty()) found.push_back(std::move(cells));
    }
    return found;
}

LiveChange computeLiveChange(const Receivers& before, const ShadowField& fieldBefore, const Receivers& after,
                             const ShadowField& fieldAfter, const std::vector<GridPlace>& places) {
    std::vector<CellChange> kinds(before.kind.size());
    std::ranges::transform(before.kind, after.kind, kinds.begin(), compareKinds);
    LiveChange change{.impact = computeDifference(fieldBefore, fieldAfter, std::move(kinds))};
    keepOpenGround(before, after, change.impact);
    for (std::size_t i = 0; i < change.figures.size(); ++i)
        change.figures[i] = computeFigures(change.impact, defaultThresholdsMin[i]);
    change.worst = findWorst(change.impact);
    change.reachesBeyond = changesAtEdge(after, change.impact);
    change.places = measurePlaces(change.impact, places);
    return change;
}

}  // namespace noonmark
