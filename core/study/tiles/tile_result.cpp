#include "core/study/tiles/tile_result.h"

#include <limits>

#include "core/base/json_number.h"

namespace noonmark {

using Json = nlohmann::json;

namespace {

Json toJson(const ComparedCell& cell) {
    return {cell.centreM.x,         cell.centreM.y,     cell.grossMin,
            cell.referenceGrossMin, cell.continuousMin, cell.referenceContinuousMin};
}

// NaN (not counted) is null in JSON.
double minutesFrom(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

ComparedCell comparedCellFrom(const Json& json) {
    return {{json.at(0), json.at(1)}, json.at(2), json.at(3), minutesFrom(json.at(4)), json.at(5)};
}

TileResult resultFrom(const Json& json) {
    const Json& sums = json.at("sums");
    TileResult result{.number = wholeNumberFrom<std::size_t>(json.at("tile")),
                      .sums = {wholeNumberFrom<std::size_t>(sums.at(0)), minutesFrom(sums.at(1)),
                               minutesFrom(sums.at(2)), sums.at(3), sums.at(4)}};
    if (json.contains("months")) result.monthMinutes = json.at("months").get<std::vector<double>>();
    if (json.contains("figures")) result.figures = json.at("figures").get<std::map<std::string, double>>();
    if (json.contains("lines")) result.lines = wholeNumberFrom<std::size_t>(json.at("lines"));
    if (json.contains("has_trees")) result.hasTrees = json.at("has_trees");
    result.cost.rays = wholeNumberFrom<std::uint64_t>(json.at("rays"));
    for (const auto& [reason, count] : json.at("skipped").items())
        result.cost.skipped[reason] = wholeNumberFrom<std::uint64_t>(count);
    result.cost.seconds = json.at("stages");
    result.engineKey = json.at("engine");
    result.engine = json.at("engine_settings");
    for (const Json& cell : json.at("compared")) result.compared.push_back(comparedCellFrom(cell));
    result.seconds = json.at("seconds");
    result.errorSeconds = json.at("error_seconds");
    if (!json.contains("content")) return result;
    result.contentHash = json.at("content");
    result.fileBytes = wholeNumberFrom<std::uintmax_t>(json.at("file_bytes"));
    result.fileSha256 = json.at("file_sha256");
    return result;
}

}  // namespace

Json toJson(const TileResult& result) {
    const ShadowSums& sums = result.sums;
    Json compared = Json::array();
    for (const ComparedCell& cell : result.compared) compared.push_back(toJson(cell));
    Json json{{"tile", result.number},
              {"sums",
               {sums.receivers, sums.grossMin, sums.continuousMin, sums.maxGrossMin, sums.maxContinuousMin}},
              {"rays", result.cost.rays},
              {"skipped", result.cost.skipped},
              {"stages", result.cost.seconds},
              {"engine", result.engineKey},
              {"engine_settings", result.engine},
              {"compared", compared},
              {"seconds", result.seconds},
              {"error_seconds", result.errorSeconds}};
    if (!result.monthMinutes.empty()) json["months"] = result.monthMinutes;
    if (!result.figures.empty()) json["figures"] = result.figures;
    if (result.lines > 0) json["lines"] = result.lines;
    if (result.hasTrees) json["has_trees"] = true;
    if (result.contentHash.empty()) return json;
    json["content"] = result.contentHash;
    json["file_bytes"] = result.fileBytes;
    json["file_sha256"] = result.fileSha256;
    return json;
}

std::optional<TileResult> tileResultFrom(const Json& json) try {
    return resultFrom(json);
} catch (const std::exception&) {  // of another structure, or numbers out of range
    return std::nullopt;
}

}  // namespace noonmark
