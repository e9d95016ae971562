#include "core/study/tile_tasks/plan/make_task_plan.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <optional>
#include <tuple>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/io/settings/read_settings.h"
#include "core/study/provenance/sha256.h"
#include "core/study/provenance/study_hash.h"
#include "core/study/study_cost.h"
#include "core/study/tile_tasks/plan/find_districts.h"
#include "core/study/tile_tasks/plan/tile_load.h"

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

namespace {

Result<void> checkRequest(const TaskPlanRequest& request, const EngineList& engines) {
    const StudySettings& settings = request.settings;
    if (settings.contributions)
        return failure("Contributions are not available for tiled studies", "study", "Leave them out");
    if (request.reading.terrainFromBases == TerrainFromBases::always)
        return failure("A terrain from the bases of buildings needs the whole city",
                       readOption("terrain_from_bases"),
                       "Give a terrain file, or " + readOption("terrain_from_bases", "never"));
    if (request.tileCells < TiledStudySettings::minTileCells ||
        request.tileCells > TiledStudySettings::maxTileCells)
        return failure("The size of a tile is out of range", "tile size", "Choose 64 to 4096 cells");
    if (const auto period = validate(settings.period); !period) return tl::make_unexpected(period.error());
    return makeEngine(settings.engine, settings.engineSettings, engines).and_then([&](const auto& engine) {
        if (request.timelines != nullptr && !engine->capabilities().stepMasks)
            return Result<void>(unsupported("This engine does not state timelines of places", settings.engine,
                                            "Choose auto, ray or projected"));
        if (request.byPlace != nullptr && !engine->capabilities().sets)
            return Result<void>(unsupported("This engine sums no months", settings.engine,
                                            "Choose auto, horizon or projected"));
        return checkBreakdown(settings, engine->capabilities(), engines);
    });
}

std::string hashTerrain(const Terrain& terrain) {
    City ground;
    ground.terrain = std::make_shared<const Terrain>(terrain);
    return hashCity(ground);
}

std::string hashContent(const std::string& study, const std::string& terrain, const PlannedTile& tile,
                        const OccluderSurvey& survey) {
    Sha256 sum;
    sum.add(study);
    sum.add(terrain);
    sum.add(tile.number);
    const OccluderSurvey::Range range = survey.cellsIn(tile.reads);
    for (int row = range.firstRow; row < range.endRow; ++row)
        for (int column = range.firstColumn; column < range.endColumn; ++column) {
            const OccluderSurvey::Cell& cell = survey.cells()[survey.grid().index(column, row)];
            if (cell.buildings == 0) continue;
            sum.add(column);
            sum.add(row);
            for (const std::uint64_t part : cell.hashSum) sum.add(part);
        }
    return sum.hex().substr(0, 32);
}

class TilePlanner {
public:
    TilePlanner(const TaskPlan& plan, const TaskPlanRequest& request, const SurveyedDistrict& surveyed,
                std::size_t district, const EngineList& engines)
        : plan_(plan),
          request_(request),
          surveyed_(surveyed),
          district_(district),
          engines_(engines),
          study_(plan.studyHash(district)),
          reach_(surveyed.sun),
          posts_(surveyed.ground.terrain ? surveyed.ground.terrain->grid.size() : 0) {
        if (request.question().places() != nullptr)
            places_.emplace(surveyed.places, plan.districts[district].tiles);
    }

    /// Nothing for a tile to leave out.
    [[nodiscard]] std::optional<PlannedTile> planned(std::size_t number) const {
        const Grid grid = measuredGrid(number);
        if (grid.size() == 0) return std::nullopt;
        const TileHalo halo = findHalo(surveyed_.survey, reach_, grid);
        if (request_.builtUpOnly && halo.buildingsInTile == 0) return std::nullopt;
        const TileCost cost = estimateTile(halo, grid, loadSettings(), surveyed_.sun, posts_, engines_);
        const double fields = request_.subject == nullptr ? 1 : request_.subject->fields;
        PlannedTile tile{.district = district_,
                         .number = number,
                         .halo = halo.occluders,
                         .reads = halo.reads,
                         .buildings = halo.buildings,
                         .seconds = cost.seconds * fields,
                         .memoryBytes = cost.memoryBytes,
                         .readBytes = cost.readBytes};
        tile.contentHash =
            hashContent(study_, plan_.districts[district_].terrainHash, tile, surveyed_.survey);
        return tile;
    }

private:
    // The cells of the tile, or around its places.
    [[nodiscard]] Grid measuredGrid(std::size_t number) const {
        if (!places_) return plan_.districts[district_].tiles.tile(number);
        const Box2 box = places_->boxOf(number);
        if (box.empty()) return {};
        return gridOver(makeRegionFromLocalBox(box), request_.settings.receivers).value_or(Grid{});
    }

    // "auto" states the masks of timelines by one of two engines.
    [[nodiscard]] StudySettings loadSettings() const {
        StudySettings settings = request_.settings;
        if (request_.timelines != nullptr && settings.engine == "auto")
            settings.engine = posts_ == 0 ? "projected" : "ray";
        return settings;
    }

    const TaskPlan& plan_;
    const TaskPlanRequest& request_;
    const SurveyedDistrict& surveyed_;
    std::size_t district_;
    const EngineList& engines_;
    std::string study_;
    ShadowReach reach_;
    std::size_t posts_;
    std::optional<PlacesOfTiles> places_;  ///< none: cells are measured
};

Result<void> addDistrict(TaskPlan& plan, std::size_t number, const TaskPlanRequest& request,
                         const InputsScan& scan, Progress& progress, const std::stop_token& stop,
                         const EngineList& engines) {
    District& district = plan.districts[number];
    const auto surveyed = surveyDistrict(district, request, scan, progress, stop);
    if (!surveyed) return tl::make_unexpected(surveyed.error());
    const auto grid = gridOver(district.region, request.settings.receivers);
    if (!grid) return tl::make_unexpected(grid.error());
    district.tiles = {*grid, request.tileCells};
    if (surveyed->ground.terrain) district.terrainHash = hashTerrain(*surveyed->ground.terrain);
    const TilePlanner planner(plan, request, *surveyed, number, engines);
    std::vector<std::optional<PlannedTile>> tiles(district.tiles.count());
    tbb::parallel_for(std::size_t(0), tiles.size(), [&](std::size_t tile) {
        if (!stop.stop_requested()) tiles[tile] = planner.planned(tile);
    });
    if (stop.stop_requested()) return cancelled();
    for (std::optional<PlannedTile>& tile : tiles)
        if (tile) plan.tiles.push_back(*std::move(tile));
    return {};
}

Result<TaskPlan> makePlan(const TaskPlanRequest& request, Progress& progress, const std::stop_token& stop,
                          const EngineList& engines) {
    if (auto sound = checkRequest(request, engines); !sound) return tl::make_unexpected(sound.error());
    const auto scan = request.subject == nullptr ? scanInputs(request, progress, stop) : InputsScan{};
    if (!scan) return tl::make_unexpected(scan.error());
    TaskPlan plan{
        .files = request.files, .fileBoxes = scan->boxesOf(request.files), .byExtent = scan->byExtent};
    plan.settingsHash = hashQuestion(request.question());
    auto districts = scan->byExtent ? findDistricts(request, *scan) : std::vector<District>(1);
    if (!districts) return tl::make_unexpected(districts.error());
    plan.districts = *std::move(districts);
    for (std::size_t i = 0; i < plan.districts.size(); ++i) {
        ProgressShare share(progress, i, plan.districts.size());
        if (auto added = addDistrict(plan, i, request, *scan, share, stop, engines); !added)
            return tl::make_unexpected(added.error());
    }
    if (plan.tiles.empty())
        return failure(request.question().places() == nullptr ? "No tile of the region holds a building"
                                                              : "No place of the file lies in the region",
                       request.region, "Choose another region");
    packTasks(plan, request.task);
    return plan;
}

}  // namespace

ReadSettings readSettingsIn(const District& district, ReadSettings reading) {
    reading.frame = district.frame;
    reading.terrainFromBases = TerrainFromBases::never;
    return reading;
}

Result<TaskPlan> makeTaskPlan(const TaskPlanRequest& request, Progress& progress, const std::stop_token& stop,
                              const EngineList& engines) {
    return guardMemory({.advice = "Choose a smaller region"},
                       [&] { return makePlan(request, progress, stop, engines); });
}

}  // namespace noonmark
