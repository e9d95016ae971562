#include "core/study/text/terrain_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

#include "core/base/json_number.h"
#include "core/base/safe_text.h"
#include "core/engines/api/tree_shade.h"
#include "core/io/heights/height_facts.h"
#include "core/measures/statistics.h"
#include "core/study/text/error_text.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<TerrainMethod, std::string_view>, 6> methods{
    {{TerrainMethod::asGiven, "as_given"},
     {TerrainMethod::kept, "source_posts_kept"},
     {TerrainMethod::bilinear, "resampled_bilinearly"},
     {TerrainMethod::averaged, "resampled_by_average"},
     {TerrainMethod::triangulated, "grid_over_triangles"},
     {TerrainMethod::fromBases, "grid_over_building_bases"}}};

std::string_view nameOf(TerrainMethod method) {
    for (const auto& [known, name] : methods)
        if (known == method) return name;
    return "as_given";
}

TerrainMethod methodOf(std::string_view name) {
    for (const auto& [method, known] : methods)
        if (known == name) return method;
    return TerrainMethod::asGiven;
}

std::string sizeText(std::size_t columns, std::size_t rows, double cellM) {
    return fmt::format("{} x {} posts {:.4g} m apart", columns, rows, cellM);
}

std::string postsText(const Terrain& terrain) {
    return sizeText(std::size_t(terrain.grid.columns), std::size_t(terrain.grid.rows), terrain.grid.cellM);
}

std::string rasterText(const TerrainSource& source) {
    return fmt::format("{} ({})", source.file,
                       sizeText(source.sourceColumns, source.sourceRows, source.sourceCellM));
}

std::string heightText(const TerrainSource& source, const char* points) {
    return fmt::format("; its surface deviates from {} by {:.2g} m (root mean square), {:.2g} m at most",
                       points, source.heightRmsM, source.heightMaxM);
}

std::string methodText(const Terrain& terrain) {
    const TerrainSource& source = terrain.source;
    switch (source.method) {
        case TerrainMethod::asGiven:
            return fmt::format("{}; its source is not known", postsText(terrain));
        case TerrainMethod::kept:
            return fmt::format(
                "{}: the raster's own rows and columns ({}), each post within {:.2g} m of its true position; "
                "nothing was resampled",
                rasterText(source), source.cut ? "those near the city" : "all of them",
                std::max(source.misplacedM, 0.0001));
        case TerrainMethod::bilinear:
            return fmt::format("{}, resampled bilinearly to {}{}", rasterText(source), postsText(terrain),
                               heightText(source, "the raster's own posts"));
        case TerrainMethod::averaged:
            return fmt::format("{}, averaged to a coarser grid of {}{}", rasterText(source),
                               postsText(terrain), heightText(source, "the raster's own posts"));
        case TerrainMethod::triangulated:
            return fmt::format("{}: triangles between {}, rasterised to a grid of {}{}", source.file,
                               countOf(source.sourcePoints, "point"), postsText(terrain),
                               heightText(source, "these points"));
        case TerrainMethod::fromBases:
            return fmt::format(
                "interpolated from the bases of the buildings, since there is no terrain: triangles between "
                "{} points of their outlines, rasterised to a grid of {}{}; the true ground between the "
                "buildings is not known",
                source.sourcePoints, postsText(terrain), heightText(source, "these points"));
    }
    return postsText(terrain);
}

Json sourceJson(const TerrainSource& source) {
    return {{"method", nameOf(source.method)},        {"file", source.file},
            {"source_columns", source.sourceColumns}, {"source_rows", source.sourceRows},
            {"source_points", source.sourcePoints},   {"source_cell_m", source.sourceCellM},
            {"misplaced_m", source.misplacedM},       {"height_rms_m", source.heightRmsM},
            {"height_max_m", source.heightMaxM},      {"filled_posts", source.filled},
            {"impossible_posts", source.impossible},  {"posts_under_buildings", source.underBuildings},
            {"cut_to_what_is_near", source.cut}};
}

// Coordinates of the first post, of the steps to the next column and row, and of the bend's terms.
Json postsJson(const PostGrid& grid) {
    Json numbers = Json::array();
    const auto add = [&](glm::dvec2 pair) {
        numbers.push_back(pair.x);
        numbers.push_back(pair.y);
    };
    for (const glm::dvec2 pair : {grid.first, grid.columnStep, grid.rowStep}) add(pair);
    for (const glm::dvec2 term : grid.bend) add(term);
    return numbers;
}

bool takePosts(const Json& json, PostGrid& grid) {
    if (!json.is_array() || json.size() != 6 + 2 * PostGrid::bendTerms) return false;
    std::size_t next = 0;
    bool sound = true;
    const auto take = [&](glm::dvec2& pair) {
        for (double* number : {&pair.x, &pair.y}) {
            const Json& value = json[next++];
            *number = value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
            sound = sound && std::abs(*number) < 1e7;
        }
    };
    for (glm::dvec2* pair : {&grid.first, &grid.columnStep, &grid.rowStep}) take(*pair);
    for (glm::dvec2& term : grid.bend) take(term);
    const glm::dvec2 a = grid.columnStep, b = grid.rowStep;
    return sound && a.x * b.y - a.y * b.x > 0;
}

// An unknown source if the text is something else.
TerrainSource sourceFrom(const Json& json) {
    if (!json.is_object()) return {};
    try {
        return {.method = methodOf(json.value("method", std::string())),
                .file = json.value("file", std::string()),
                .sourceColumns = wholeNumberIn(json, "source_columns", std::size_t(0)),
                .sourceRows = wholeNumberIn(json, "source_rows", std::size_t(0)),
                .sourcePoints = wholeNumberIn(json, "source_points", std::size_t(0)),
                .sourceCellM = json.value("source_cell_m", 0.0),
                .misplacedM = json.value("misplaced_m", 0.0),
                .heightRmsM = json.value("height_rms_m", 0.0),
                .heightMaxM = json.value("height_max_m", 0.0),
                .filled = wholeNumberIn(json, "filled_posts", std::size_t(0)),
                .impossible = wholeNumberIn(json, "impossible_posts", std::size_t(0)),
                .underBuildings = wholeNumberIn(json, "posts_under_buildings", std::size_t(0)),
                .cut = json.value("cut_to_what_is_near", false)};
    } catch (const std::exception&) {  // of another structure, or numbers out of range
        return {};
    }
}

std::string shareText(std::size_t off, std::size_t all, double farthestM) {
    return fmt::format("{} of {} ({:.1f} %), up to {:.0f} m from it", off, all,
                       100.0 * double(off) / double(all), farthestM);
}

}  // namespace

std::string formatText(const Terrain& terrain) {
    const TerrainSource& source = terrain.source;
    std::string text = methodText(terrain);
    if (source.filled > 0)
        text += fmt::format("; filled from the posts around: {} without elevation",
                            countOf(source.filled, "post"));
    if (source.underBuildings > 0)
        text += fmt::format(
            "; it shows a surface with buildings: {} posts on them and on trees got the ground around them",
            source.underBuildings);
    return text;
}

std::string formatText(const TerrainCoverage& coverage) {
    if (coverage.receivers.off == 0 && coverage.casters.off == 0) return {};
    std::string text = "Beyond the terrain, on its nearest elevation:";
    if (const auto& share = coverage.receivers; share.off > 0)
        text += " receivers, " + shareText(share.off, share.all, share.farthestM);
    if (coverage.receivers.off > 0 && coverage.casters.off > 0) text += ";";
    if (const auto& share = coverage.casters; share.off > 0)
        text += " buildings whose shadow can reach them, " + shareText(share.off, share.all, share.farthestM);
    return text;
}

Json terrainJson(const Terrain& terrain) {
    const PostGrid& grid = terrain.grid;
    Json json{{"text", formatText(terrain)},
              {"columns", grid.columns},
              {"rows", grid.rows},
              {"cell_m", grid.cellM},
              {"turned_from_true_north_deg",
               std::atan2(-grid.columnStep.y, grid.columnStep.x) * 180 / std::numbers::pi}};
    const Json source = sourceJson(terrain.source);
    for (const auto& [key, value] : source.items()) json[key] = value;
    return json;
}

Json makeCoverageJson(const TerrainCoverage& coverage) {
    const auto share = [](const TerrainCoverage::Share& of) -> Json {
        return {{"all", of.all}, {"off", of.off}, {"far_off", of.farOff}, {"farthest_m", of.farthestM}};
    };
    return {
        {"receivers", share(coverage.receivers)},
        {"buildings_in_reach", share(coverage.casters)},
        {"off",
         "more than half a cell beyond the terrain's outer posts; placed at the nearest post's elevation"},
        {"far_off", "how many of them are farther from the terrain than its shorter side"}};
}

std::string sourceText(const Terrain& terrain) {
    Json json = sourceJson(terrain.source);
    json["posts"] = postsJson(terrain.grid);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool takeSource(const std::string& text, Terrain& terrain) {
    const Json json = Json::parse(text, nullptr, false);
    terrain.source = sourceFrom(json);
    return !json.is_object() || !json.contains("posts") || takePosts(json.at("posts"), terrain.grid);
}

namespace {

std::size_t countTrees(const Trees& trees, TreeSource Tree::*source, TreeSource value) {
    return std::size_t(std::ranges::count(trees.trees, value, source));
}

Json sourcesJson(const Trees& trees, TreeSource Tree::*source) {
    Json json = Json::object();
    for (const TreeSource value : treeSources)
        json[std::string(nameOf(value))] = countTrees(trees, source, value);
    return json;
}

std::string describeSources(const Trees& trees, TreeSource Tree::*source) {
    std::string text;
    for (const TreeSource value : treeSources)
        if (const std::size_t count = countTrees(trees, source, value); count > 0)
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", formatThousands(count), nameOf(value));
    return text;
}

}  // namespace

Json treesJson(const Trees& trees) {
    Json json{{"count", trees.trees.size()},
              {"evergreen", std::ranges::count(trees.trees, true, &Tree::evergreen)},
              {"height_sources", sourcesJson(trees, &Tree::heightSource)},
              {"crown_sources", sourcesJson(trees, &Tree::crownSource)}};
    const LeafDays& leaf = trees.leafDays;
    json["leaf_on"] = leaf.on == leaf.off ? Json() : Json(formatDayOfYear(leaf.on));
    json["leaf_off"] = leaf.on == leaf.off ? Json() : Json(formatDayOfYear(leaf.off));
    const auto own = std::ranges::count_if(
        trees.trees, [](const Tree& tree) { return tree.leafOnDay || tree.leafOffDay; });
    if (own > 0) json["own_leaf_days"] = own;
    return json;
}

Json treesJson(const Trees& trees, const ShadowField& field) {
    Json json = treesJson(trees);
    json["used"] = field.trees ? field.trees->treesUsed : 0;
    if (!field.trees) return json;
    json["shaded_from"] = field.trees->shadedFrom;
    json["how"] = field.trees->how;
    const double bareMin = computeStatistics(field).meanGrossMin;
    for (const ShadeColumn& shade : listShadeColumns(field)) {
        const double allMin = computeStatistics(*shade.field).meanGrossMin;
        json["share_of_shade" + suffixOf(shade.column)] = allMin > 0 ? Json(1 - bareMin / allMin) : Json();
    }
    return json;
}

std::string describeTrees(const Trees& trees) {
    return fmt::format("{}; heights: {}; crowns: {}", formatThousands(trees.trees.size()),
                       describeSources(trees, &Tree::heightSource),
                       describeSources(trees, &Tree::crownSource));
}

std::string describeTrees(const Trees& trees, std::size_t used) {
    return fmt::format("{} can reach a receiver, of {}; trunks are left out", formatThousands(used),
                       describeTrees(trees));
}

std::string describeTrees(const Trees& trees, const ShadowField& field) {
    return describeTrees(trees, field.trees ? field.trees->treesUsed : 0);
}

}  // namespace noonmark
