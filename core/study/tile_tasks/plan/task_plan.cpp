#include "core/study/tile_tasks/plan/task_plan.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/base/json_number.h"
#include "core/base/version.h"
#include "core/io/files/plain_file.h"
#include "core/io/files/write_text.h"
#include "core/study/provenance/sha256.h"
#include "core/study/provenance/study_hash.h"

namespace noonmark {

std::string hashQuestion(const TaskQuestion& question) {
    StudySettings settings = question.settings;
    settings.region = {};
    const std::string hash = hashSettings(settings);
    if (question.subject == nullptr && question.places() == nullptr) return hash;
    Sha256 sum;
    sum.add(hash);
    if (question.subject != nullptr) sum.add(question.subject->key);
    if (question.timelines != nullptr) sum.add(question.timelines->key());
    if (question.byPlace != nullptr) sum.add(question.byPlace->key());
    return sum.hex();
}

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

/// Whether a plan that was read is one that makeTaskPlan() could have made: numbers finite and in range,
/// names of districts that stay in the folder, tiles of the districts, sorted by tasks, none empty,
/// that do not mix districts, and in them by windows. plan.json may come from a stranger.
bool isSound(const TaskPlan& plan) {
    return areTasksSound(plan) && plan.fileBoxes.size() == plan.files.size() &&
           std::ranges::all_of(plan.districts, isSoundDistrict) &&
           std::ranges::all_of(plan.tiles, [&](const PlannedTile& tile) { return isSoundTile(tile, plan); });
}

}  // namespace

using Json = nlohmann::ordered_json;

namespace {

constexpr int planVersion = 3;

Json ringJson(const Ring& ring) {
    Json points = Json::array();
    for (const glm::vec2 point : ring) {
        points.push_back(point.x);
        points.push_back(point.y);
    }
    return points;
}

glm::vec2 pointFrom(const Json& json, std::size_t first) {
    return {json.at(first).get<float>(), json.at(first + 1).get<float>()};
}

Ring ringFrom(const Json& json) {
    Ring ring;
    for (std::size_t i = 0; i < json.size(); i += 2) ring.push_back(pointFrom(json, i));
    return ring;
}

Json regionJson(const Region& region) {
    Json polygons = Json::array();
    for (const Footprint& polygon : region.polygons) {
        Json rings = Json::array({ringJson(polygon.outer)});
        for (const Ring& hole : polygon.holes) rings.push_back(ringJson(hole));
        polygons.push_back(std::move(rings));
    }
    return {{"name", region.name}, {"polygons", std::move(polygons)}};
}

Region regionFrom(const Json& json) {
    Region region{json.at("name"), {}};
    for (const Json& rings : json.at("polygons")) {
        Footprint& polygon = region.polygons.emplace_back();
        polygon.outer = ringFrom(rings.at(0));
        for (std::size_t i = 1; i < rings.size(); ++i) polygon.holes.push_back(ringFrom(rings.at(i)));
    }
    return region;
}

Json districtJson(const District& district) {
    const Grid& grid = district.tiles.whole;
    const LonLat origin = district.frame.origin();
    return {{"name", district.name},
            {"origin", {origin.lonDeg, origin.latDeg, district.frame.originElevationM()}},
            {"grid", {grid.westM, grid.southM, grid.cellM, grid.columns, grid.rows}},
            {"tile_cells", district.tiles.side},
            {"region", regionJson(district.region)},
            {"terrain_hash", district.terrainHash}};
}

District districtFrom(const Json& json) {
    const Json& origin = json.at("origin");
    const Json& grid = json.at("grid");
    District district{json.at("name"), Frame({origin.at(0), origin.at(1)}, origin.at(2)),
                      regionFrom(json.at("region")),
                      TilePlan{{grid.at(0), grid.at(1), grid.at(2), wholeNumberFrom<int>(grid.at(3)),
                                wholeNumberFrom<int>(grid.at(4))},
                               wholeNumberFrom<int>(json.at("tile_cells"))},
                      json.at("terrain_hash")};
    return district;
}

Json boxJson(const Box2& box) { return {box.low.x, box.low.y, box.high.x, box.high.y}; }
Box2 boxFrom(const Json& json) { return {pointFrom(json, 0), pointFrom(json, 2)}; }

Json tileJson(const PlannedTile& tile) {
    return {tile.task,           tile.district,    tile.number,    boxJson(tile.halo),
            boxJson(tile.reads), tile.contentHash, tile.buildings, tile.seconds,
            tile.memoryBytes,    tile.window,      tile.readBytes};
}

PlannedTile tileFrom(const Json& json) {
    return {.district = wholeNumberFrom<std::size_t>(json.at(1)),
            .number = wholeNumberFrom<std::size_t>(json.at(2)),
            .halo = boxFrom(json.at(3)),
            .reads = boxFrom(json.at(4)),
            .contentHash = json.at(5),
            .buildings = wholeNumberFrom<std::size_t>(json.at(6)),
            .seconds = json.at(7),
            .memoryBytes = json.at(8),
            .readBytes = json.at(10),
            .task = wholeNumberFrom<std::size_t>(json.at(0)),
            .window = wholeNumberFrom<std::size_t>(json.at(9))};
}

Json lonLatBoxJson(const LonLatBox& box) { return {box.westDeg, box.southDeg, box.eastDeg, box.northDeg}; }
LonLatBox lonLatBoxFrom(const Json& json) { return {json.at(0), json.at(1), json.at(2), json.at(3)}; }

Json inputJson(const InputFile& input) {
    return {{"path", input.path.string()}, {"bytes", input.bytes}, {"sha256", input.sha256}};
}

std::string planText(const TaskPlan& plan) {
    Json json{{"noonmark_task_plan", planVersion},
              {"program", "Noonmark " + std::string(version())},
              {"files", plan.files},
              {"file_boxes", Json::array()},
              {"arguments", plan.arguments},
              {"inputs", Json::array()},
              {"settings_hash", plan.settingsHash},
              {"by_window", plan.byExtent},
              {"task_count", plan.taskCount},
              {"districts", Json::array()}};
    for (const LonLatBox& box : plan.fileBoxes) json["file_boxes"].push_back(lonLatBoxJson(box));
    for (const InputFile& input : plan.inputs) json["inputs"].push_back(inputJson(input));
    for (const District& district : plan.districts) json["districts"].push_back(districtJson(district));
    json["tile_columns"] = {"task",      "district", "number",       "halo",   "reads",     "content_hash",
                            "buildings", "seconds",  "memory_bytes", "window", "read_bytes"};
    std::string text = json.dump(1);
    text.resize(text.size() - 2);  // the closing brace and its line
    text += ",\n \"tiles\": [";
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        text += (i == 0 ? "\n" : ",\n") + tileJson(plan.tiles[i]).dump();
    return text + "\n]}\n";
}

TaskPlan planFrom(const Json& json) {
    TaskPlan plan{.files = json.at("files"),
                  .arguments = json.at("arguments"),
                  .settingsHash = json.at("settings_hash"),
                  .byExtent = json.at("by_window"),
                  .taskCount = wholeNumberFrom<std::size_t>(json.at("task_count"))};
    for (const Json& box : json.at("file_boxes")) plan.fileBoxes.push_back(lonLatBoxFrom(box));
    for (const Json& input : json.at("inputs"))
        plan.inputs.push_back({std::string(input.at("path")),
                               wholeNumberFrom<std::uintmax_t>(input.at("bytes")), input.at("sha256")});
    for (const Json& district : json.at("districts")) plan.districts.push_back(districtFrom(district));
    for (const Json& tile : json.at("tiles")) plan.tiles.push_back(tileFrom(tile));
    if (!isSound(plan)) throw std::out_of_range("what no plan holds");
    return plan;
}

// An input may be out of reach where the plan is merged; where it is there, it must be a file.
Result<void> checkFilesOf(const TaskPlan& plan) {
    std::vector<std::filesystem::path> inputs(plan.files.begin(), plan.files.end());
    for (const InputFile& input : plan.inputs) inputs.push_back(input.path);
    for (const std::filesystem::path& input : inputs)
        if (std::error_code ignored; std::filesystem::exists(input, ignored))
            if (auto plain = checkPlainFile(input); !plain) return plain;
    return {};
}

}  // namespace

std::string TaskPlan::studyHash(std::size_t district) const {
    Sha256 sum;
    const District& own = districts.at(district);
    sum.add(settingsHash);
    for (const double number :
         {own.frame.origin().lonDeg, own.frame.origin().latDeg, own.frame.originElevationM()})
        sum.add(number);
    sum.add(regionJson(own.region).dump());
    return sum.hex();
}

std::vector<PlannedTile> TaskPlan::tilesOf(std::size_t task) const {
    const auto first = std::ranges::lower_bound(tiles, task, {}, &PlannedTile::task);
    return {first, std::ranges::upper_bound(first, tiles.end(), task, {}, &PlannedTile::task)};
}

std::filesystem::path taskFolder(const std::filesystem::path& plan, std::size_t task) {
    return plan / "tasks" / fmt::format("{:05}", task);
}

Result<void> writeTaskPlan(const std::filesystem::path& folder, const TaskPlan& plan) {
    return writeText(folder / planFileName, planText(plan));
}

Result<TaskPlan> readTaskPlan(const std::filesystem::path& folder) try {
    const std::filesystem::path file = folder / planFileName;
    if (auto plain = checkNoLink(file); !plain) return tl::make_unexpected(plain.error());
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return failure("There is no plan of tiles in this folder", file.string(),
                       "Make one with `noonmark-cli tiles plan`");
    const Json json = Json::parse(stream);
    if (json.at("noonmark_task_plan") != planVersion)
        return failure("The plan is of another version of Noonmark", file.string(),
                       "Plan again, or use that version");
    TaskPlan plan = planFrom(json);
    if (auto plain = checkFilesOf(plan); !plain) return tl::make_unexpected(plain.error());
    return plan;
} catch (const std::exception&) {
    return failure("The plan is damaged", (folder / planFileName).string(), "Plan again");
}

}  // namespace noonmark
