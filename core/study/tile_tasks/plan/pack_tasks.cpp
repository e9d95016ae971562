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

/// The tiles of a window so far. What lies between their halos is taken to be as dense as the densest of
/// them.
struct ExtentLoad {
    double ownBytes = 0;  ///< the most that a tile needs beside what it reads
    double readBytesPerM2 = 0;
    Box2 reads;

    [[nodiscard]] ExtentLoad with(const PlannedTile& tile) const {
        ExtentLoad more = *this;
        more.reads.add(tile.reads);
        more.ownBytes = std::max(ownBytes, tile.memoryBytes - tile.readBytes);
        if (const double area = areaOf(tile.reads); area > 0)
            more.readBytesPerM2 = std::max(readBytesPerM2, tile.readBytes / area);
        return more;
    }
    [[nodiscard]] double memoryBytes() const { return ownBytes + readBytesPerM2 * areaOf(reads); }
};

void sortAlongCurve(TaskPlan& plan) {
    std::ranges::sort(plan.tiles, {}, [&](const PlannedTile& tile) {
        return std::tuple(tile.district, curvePosition(tile, plan.districts.at(tile.district).tiles));
    });
}

/// Sets the task of each tile, in the order of `tiles`. Returns the number of tasks.
std::size_t fillTasks(std::vector<PlannedTile>& tiles, double secondsOfTask) {
    std::size_t task = 0, district = 0;
    double seconds = 0;
    for (PlannedTile& tile : tiles) {
        const bool first = &tile == &tiles.front();
        if (!first && (tile.district != district || seconds + tile.seconds > secondsOfTask)) {
            ++task;
            seconds = 0;
        }
        seconds += tile.seconds;
        district = tile.district;
        tile.task = task;
    }
    return tiles.empty() ? 0 : task + 1;
}

void fillExtents(std::vector<PlannedTile>& tiles, double bytesOfExtent) {
    ExtentLoad load;
    std::size_t task = 0, window = 0;
    for (PlannedTile& tile : tiles) {
        const bool begins = &tile == &tiles.front() || tile.task != task;
        const ExtentLoad more = load.with(tile);
        const bool fits = !begins && more.memoryBytes() <= bytesOfExtent;
        window = begins ? 0 : fits ? window : window + 1;
        load = fits ? more : ExtentLoad().with(tile);
        task = tile.task;
        tile.window = window;
    }
}

}  // namespace

std::size_t packTasks(TaskPlan& plan, const TaskSize& size) {
    sortAlongCurve(plan);
    plan.taskCount = fillTasks(plan.tiles, size.seconds);
    if (plan.byExtent) fillExtents(plan.tiles, size.memoryBytes);
    return plan.taskCount;
}

double largestExtentBytes(const TaskPlan& plan) {
    ExtentLoad load;
    double largest = 0;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const PlannedTile& tile = plan.tiles[i];
        const bool begins =
            i == 0 || tile.task != plan.tiles[i - 1].task || tile.window != plan.tiles[i - 1].window;
        load = begins ? ExtentLoad().with(tile) : load.with(tile);
        largest = std::max(largest, load.memoryBytes());
    }
    return largest;
}

}  // namespace noonmark
