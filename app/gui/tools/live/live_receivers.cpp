#include "app/gui/tools/live/live_receivers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/receivers/grid_box.h"
#include "core/receivers/roof_receivers.h"

namespace noonmark {

namespace {

City within(const City& city, const Grid& grid) {
    City some{.frame = city.frame, .terrain = city.terrain, .context = city.context};
    for (const auto& building : city.buildings)
        if (overlaps(bounds(*building), grid)) some.buildings.push_back(building);
    return some;
}

// First and last cell of an interval along one axis, widened by one cell on either side and limited to the
// grid.
std::pair<int, int> cellsOf(double low, double high, double beginM, double cellM, int count) {
    const auto at = [&](double metres) { return std::clamp((metres - beginM) / cellM, -2.0, count + 2.0); };
    return {std::clamp(int(std::floor(at(low))) - 1, 0, count - 1),
            std::clamp(int(std::floor(at(high))) + 1, 0, count - 1)};
}

/// A rectangle of a grid's cells.
struct Patch {
    Grid grid;
    int column = 0, row = 0;  // its first cell in the whole grid
};

std::optional<Patch> patchOf(const Box2& box, const Grid& whole) {
    if (!overlaps(box, whole)) return std::nullopt;
    const auto [west, east] =
        cellsOf(double(box.low.x), double(box.high.x), whole.westM, whole.cellM, whole.columns);
    const auto [south, north] =
        cellsOf(double(box.low.y), double(box.high.y), whole.southM, whole.cellM, whole.rows);
    return Patch{{whole.westM + west * whole.cellM, whole.southM + south * whole.cellM, whole.cellM,
                  east - west + 1, north - south + 1},
                 west,
                 south};
}

// Copies the kind of each cell and the height of roofs. The ground keeps its height, whatever is built on it.
void paste(const Receivers& part, const Patch& patch, Receivers& receivers) {
    for (int row = 0; row < part.grid.rows; ++row)
        for (int column = 0; column < part.grid.columns; ++column) {
            const std::size_t from = part.grid.index(column, row),
                              to = receivers.grid.index(patch.column + column, patch.row + row);
            receivers.kind[to] = part.kind[from];
            if (part.kind[from] == CellKind::roof) receivers.groundM[to] = part.groundM[from];
        }
}

void listReceivers(Receivers& receivers) {
    receivers.cells.clear();
    for (std::size_t cell = 0; cell < receivers.kind.size(); ++cell)
        if (isReceiver(receivers.kind[cell])) receivers.cells.push_back(std::uint32_t(cell));
}

}  // namespace

Result<LiveReceivers> LiveReceivers::of(const City& city, const Region& region,
                                        const ReceiverSettings& settings, const std::stop_token& stop) {
    auto base = placeReceivers(city, region, settings, stop);
    if (!base) return tl::make_unexpected(base.error());
    LiveReceivers made;
    made.near_ = within(city, base->grid);
    made.region_ = region;
    made.places_ = settings.places;
    made.base_ = *std::move(base);
    return made;
}

Receivers LiveReceivers::with(const Shape& shape) const {
    Receivers receivers = base_;
    for (const auto& added : shape) patch(receivers, *added, shape);
    if (!shape.empty()) listReceivers(receivers);
    return receivers;
}

void LiveReceivers::patch(Receivers& receivers, const Building& added, const Shape& shape) const {
    const auto patch = patchOf(bounds(added), receivers.grid);
    if (!patch) return;
    City city = within(near_, patch->grid);
    city.buildings.insert(city.buildings.end(), shape.begin(), shape.end());
    const auto ground = placeReceiversInPart(city, region_, patch->grid);
    if (ground) paste(placeAtHeights(*ground, city, places_), *patch, receivers);  // fails only if stopped
}

}  // namespace noonmark
