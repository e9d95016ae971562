#include "core/study/tile_tasks/plan/pack_tasks.h"

#include <algorithm>
#include <tuple>

namespace noonmark {

namespace {

std::uint64_t spread(std::uint64_t bits) {
    std::uint64_t every = 0;
    for (int i = 0; i < 32; ++i) every |= (bits >> i & 1) << (2 * i);
    return every;
}

std::uint64_t curvePosition(const PlannedTile& tile, const TilePlan& plan) {
    const auto columns = std::size_t(plan.columns());
    return spread(tile.number % columns) | spread(tile.number / columns) << 1;
}

double areaOf(const Box2& box) { return double(box.high.x - box.low.x) * double(box.high.y - box.low.y); }

/// The tiles of a task so far. Its memory is that of its largest tile, more what the other halos add.
struct Load {
    double seconds = 0;
    double memoryBytes = 0;
    Box2 reads;
    std::size_t district = 0;
    bool empty = true;

    [[nodiscard]] Load with(const PlannedTile& tile) const {
        Load more = *this;
        more.reads.add(tile.reads);
        more.district = tile.district;
        more.seconds += tile.seconds;
        const double own = areaOf(tile.reads);
        const double growth = own > 0 ? areaOf(more.reads) / own : 1;
        more.memoryBytes = std::max(memoryBytes, tile.memoryBytes * std::max(1.0, growth));
        more.empty = false;
        return more;
    }
};

}  // namespace

std::size_t packTasks(TaskPlan& plan, const TaskSize& size) {
    std::ranges::sort(plan.tiles, {}, [&](const PlannedTile& tile) {
        return std::tuple(tile.district, curvePosition(tile, plan.districts.at(tile.district).tiles));
    });
    Load load;
    std::size_t task = 0;
    for (PlannedTile& tile : plan.tiles) {
        const Load more = load.with(tile);
        const bool fits = load.empty || (tile.district == load.district && more.seconds <= size.seconds &&
                                         more.memoryBytes <= size.memoryBytes);
        if (!fits) ++task;
        load = fits ? more : Load().with(tile);
        tile.task = task;
    }
    plan.taskCount = plan.tiles.empty() ? 0 : task + 1;
    return plan.taskCount;
}

}  // namespace noonmark
