#include "core/study/tile_tasks/plan/check_task_plan.h"

#include <algorithm>
#include <cmath>

#include "core/receivers/receivers.h"

namespace noonmark {

namespace {

constexpr int maxCellsAcross = 1'000'000'000;  // TilePlan adds two such numbers
constexpr double farthestM = 1e9;

bool isFinite(const Box2& box) {
    return std::isfinite(box.low.x) && std::isfinite(box.low.y) && std::isfinite(box.high.x) &&
           std::isfinite(box.high.y);
}

bool isSoundRing(const Ring& ring) {
    return ring.size() >= 3 && std::ranges::all_of(ring, [](glm::vec2 point) {
               return std::isfinite(point.x) && std::isfinite(point.y);
           });
}

bool isSoundPolygon(const Footprint& polygon) {
    return isSoundRing(polygon.outer) && std::ranges::all_of(polygon.holes, isSoundRing);
}

bool isSoundGrid(const TilePlan& tiles) {
    const Grid& grid = tiles.whole;
    const auto counts = [](int cells) { return cells >= 1 && cells <= maxCellsAcross; };
    const auto near = [](double metres) { return std::abs(metres) <= farthestM; };
    const bool cells = grid.cellM >= ReceiverSettings::minCellM && grid.cellM <= ReceiverSettings::maxCellM;
    return counts(tiles.side) && counts(grid.columns) && counts(grid.rows) && cells && near(grid.westM) &&
           near(grid.southM) && near(grid.eastM()) && near(grid.northM());
}

bool isSoundPlace(const Frame& frame) {
    const LonLat origin = frame.origin();
    return std::abs(origin.lonDeg) <= 180 && std::abs(origin.latDeg) <= 90 &&
           std::abs(frame.originElevationM()) <= farthestM;
}

// The name begins the names of files.
bool isSoundName(const std::string& name) {
    return std::ranges::all_of(name, [](char letter) {
        return letter == '-' || (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
    });
}

bool isSoundDistrict(const District& district) {
    return isSoundName(district.name) && isSoundPlace(district.frame) && isSoundGrid(district.tiles) &&
           std::ranges::all_of(district.region.polygons, isSoundPolygon);
}

bool isSoundTile(const PlannedTile& tile, const TaskPlan& plan) {
    return tile.district < plan.districts.size() &&
           tile.number < plan.districts[tile.district].tiles.count() && isFinite(tile.halo) &&
           isFinite(tile.reads) && tile.task < plan.taskCount;
}

// A task begins with its window 0, and no task or window is left out.
bool follows(const PlannedTile& tile, const PlannedTile& next, bool byExtent) {
    if (next.task == tile.task + 1) return next.window == 0;
    const bool sameExtent = next.window == tile.window;
    return next.task == tile.task && next.district == tile.district &&
           (sameExtent || (byExtent && next.window == tile.window + 1));
}

bool areTasksSound(const TaskPlan& plan) {
    if (plan.tiles.empty()) return plan.taskCount == 0;
    if (plan.tiles.front().task != 0 || plan.tiles.front().window != 0) return false;
    for (std::size_t i = 1; i < plan.tiles.size(); ++i)
        if (!follows(plan.tiles[i - 1], plan.tiles[i], plan.byExtent)) return false;
    return plan.tiles.back().task + 1 == plan.taskCount;
}

}  // namespace

bool isSound(const TaskPlan& plan) {
    return areTasksSound(plan) && plan.fileBoxes.size() == plan.files.size() &&
           std::ranges::all_of(plan.districts, isSoundDistrict) &&
           std::ranges::all_of(plan.tiles, [&](const PlannedTile& tile) { return isSoundTile(tile, plan); });
}

}  // namespace noonmark
