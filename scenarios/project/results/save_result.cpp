#include "scenarios/project/results/save_result.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <cmath>

#include "core/describe/figure_text.h"
#include "core/study/contributions/place_contributions.h"
#include "core/study/elements/element_tables.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/provenance/study_hash.h"
#include "core/study/text/error_text.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/project/results/saved_answer.h"
#include "scenarios/project/results/saved_figures_json.h"
#include "scenarios/project/tables/geopackage.h"
#include "scenarios/project/tables/grid_tiles.h"
#include "scenarios/project/tables/layer_styles.h"
#include "scenarios/project/write_project.h"
#include "scenarios/settings_json.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

std::string hashOf(const Project& project, const std::string& scenario) {
    const auto city = cityOf(project, scenario);
    return city ? hashCity(city->city) : std::string();
}

std::string formatText(std::chrono::sys_seconds at) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(at)));
}

Json originJson(std::chrono::sys_seconds at, const std::string& citySha256, const StudySettings& settings) {
    return {{"at", formatText(at)}, {"city_sha256", citySha256}, {"question_sha256", hashQuestion(settings)}};
}

// How long each day is: hours of sun are stated as minutes of shadow by it.
Json daylightJson(const SunSteps& sun) {
    Json days = Json::array();
    for (const SunDay& day : sun.days)
        days.push_back(Json::array({Json(noonmark::formatText(day.date)), Json(day.count)}));
    return {{"step_min", sun.stepMinutes}, {"days", std::move(days)}};
}

std::string withOrigin(const std::string& settings, Json origin) {
    Json json = Json::parse(settings);
    json["kept"] = std::move(origin);
    return toJsonText(json);
}

Json originOf(const Project& project, const ImpactAnswer& answer, std::chrono::sys_seconds at) {
    Json json = originJson(at, hashOf(project, answer.to), answer.settings.study);
    if (const std::string hash = hashOf(project, answer.from); !hash.empty()) json["baseline_sha256"] = hash;
    json["changed_cells"] = changedCellsJson(answer.study.total.change);
    return json;
}

Json originOf(const Project& project, const ScoreAnswer& answer, std::chrono::sys_seconds at) {
    Json json = originJson(at, hashOf(project, answer.scenario), answer.settings);
    json["weights"] = Json::parse(weightsJson(answer.weights));
    return json;
}

// As study.json leaves them to their own file. Null: none were asked for.
Json contributionsJson(const Study& study) {
    if (!study.settings.contributions || !study.breakdown) return {};
    Json json = Json::array();
    for (const Contribution& one : listContributions(study.city, *study.breakdown, study.sun.dayCount())) {
        json.push_back({{"source_id", one.id}, {"name", one.name}});
        json.back().update(figuresJson(contributionFigures().of(one)));
    }
    return json;
}

std::string inputsOf(const Project& project) { return inputsJson(project.inputs).dump(); }

void addLayers(std::vector<SavedLayer>& layers, const ShadowField& field, const std::string& with) {
    layers.push_back({grossLayer + with, "min/day", field.grossMin});
    if (hasRuns(field)) layers.push_back({runLayer + with, "min", field.continuousMin});
}

// Other programs open each layer as a map, so layers without any value are left out.
std::vector<SavedLayer> layersOf(const ShadowField& field) {
    std::vector<SavedLayer> layers;
    addLayers(layers, field, {});
    for (const ShadeColumn& shade : listShadeColumns(field))
        addLayers(layers, *shade.field, layerEnding(shade.column));
    return layers;
}

std::vector<SavedLayer> layersOf(const ImpactStudy& study) {
    const Impact& impact = study.total;
    std::vector<SavedLayer> layers{{"change of gross shadow", "min/day", impact.grossMin}};
    if (hasRuns(impact)) layers.push_back({"change of continuous shadow", "min", impact.continuousMin});
    for (const auto& [name, field] :
         {std::pair(beforeLayer, &study.before), std::pair(afterLayer, &study.after)})
        if (field->grossMin.size() == impact.grid.size())
            layers.push_back({name, "min/day", field->grossMin});
    return layers;
}

double roundToMm(float metres) { return std::round(double(metres) * 1000) / 1000; }

Json ringJson(const Ring& ring) {
    Json json = Json::array();
    for (const glm::vec2& corner : ring) json.push_back({roundToMm(corner.x), roundToMm(corner.y)});
    return json;
}

// Of each place a list of polygons, of each polygon its outer ring and then its holes, local metres.
Json outlinesJson(const std::vector<Place>& places) {
    Json json = Json::array();
    for (const Place& place : places) {
        Json polygons = Json::array();
        for (const Footprint& polygon : place.polygons) {
            Json rings = Json::array({ringJson(polygon.outer)});
            for (const Ring& hole : polygon.holes) rings.push_back(ringJson(hole));
            polygons.push_back(std::move(rings));
        }
        json.push_back(std::move(polygons));
    }
    return json;
}

Project nameResult(Project project, const std::string& name, SavedResult result) {
    result.name = name;
    return addResult(std::move(project), std::move(result));
}

}  // namespace

SavedResult makeSavedResult(const Project& project, const std::string& scenario, const Study& study,
                            std::chrono::sys_seconds at) {
    const ShadowField& field = study.field;
    Json origin = originJson(at, hashCity(study.city), study.settings);
    if (Json contributions = contributionsJson(study); !contributions.is_null())
        origin["contributions"] = std::move(contributions);
    if (study.byTree) origin["tree_contributions"] = treeContributionsJson(listTreeContributions(study));
    return {{},
            "study",
            scenario,
            {},
            withOrigin(studyJson(study), std::move(origin)),
            inputsOf(project),
            field.grid,
            layersOf(field)};
}

// The columns that state where the points' table comes from are kept with it.
SavedResult makeSavedResult(const Project& project, const std::string& scenario, const ElementStudy& study,
                            std::chrono::sys_seconds at) {
    Json origin = originJson(at, hashCity(study.city), study.settings);
    origin["source"] = sourceValues(study.provenance);
    return {{},
            "elements",
            scenario,
            {},
            withOrigin(elementStudyJson(study, {}), std::move(origin)),
            inputsOf(project),
            {0, 0, 1, 1, 1},
            {},
            makeElementMap(study).elements};
}

SavedResult makeSavedResult(const Project& project, const ImpactAnswer& answer, std::chrono::sys_seconds at) {
    const Impact& impact = answer.study.total;
    return {{},
            "impact",
            answer.to,
            answer.from,
            withOrigin(impactJson(answer), originOf(project, answer, at)),
            inputsOf(project),
            impact.grid,
            layersOf(answer.study)};
}

SavedResult makeSavedResult(const Project& project, const ScoreAnswer& answer, std::chrono::sys_seconds at) {
    return {{},
            "score",
            answer.scenario,
            {},
            withOrigin(scoreJson(answer), originOf(project, answer, at)),
            inputsOf(project),
            answer.score.grid,
            {{"shadow score", "", answer.score.score}}};
}

// The grid means nothing; the keys that other kinds of results state are those of readSavedAnswer().
SavedResult makeSavedResult(const Project& project, const SunOfCities& sun, std::chrono::sys_seconds at) {
    const SunByPlace& baseline = sun.baseline;
    const SunByPlace& shown = sun.compared.empty() ? baseline : sun.compared.back().sun;
    Json origin = originJson(at, hashCity(shown.city), baseline.settings.study);
    if (!sun.compared.empty()) origin["baseline_sha256"] = hashCity(baseline.city);
    for (const ComparedSun& compared : sun.compared)
        if (&compared != &sun.compared.back())
            origin["others_sha256"][compared.sun.name] = hashCity(compared.sun.city);
    origin["places"] = outlinesJson(baseline.places);
    origin["daylight"] = daylightJson(baseline.daylight);
    Json json = Json::parse(toJson(baseline, sun.compared));
    json["engine_settings"] = baseline.field.engine;
    json["region"] = "places";
    json["kept"] = std::move(origin);
    return {{},
            "by-place",
            shown.name,
            sun.compared.empty() ? std::string() : baseline.name,
            toJsonText(json),
            inputsOf(project),
            {0, 0, 1, 1, 1},
            {}};
}

SavedResult makeSavedResult(const Project& project, const std::string& kind, const std::string& scenario,
                            const std::string& baseline, Json json, std::chrono::sys_seconds at) {
    json["kept"] = {{"at", formatText(at)}, {"city_sha256", hashOf(project, scenario)}};
    if (!baseline.empty()) json["kept"]["baseline_sha256"] = hashOf(project, baseline);
    return {{}, kind, scenario, baseline, toJsonText(json), inputsOf(project), {0, 0, 1, 1, 1}, {}};
}

Project addResult(Project project, SavedResult result) {
    std::erase_if(project.results, [&](const auto& old) { return old->name == result.name; });
    project.results.push_back(std::make_shared<const SavedResult>(std::move(result)));
    return project;
}

Project addResult(Project project, const std::string& name, const std::string& scenario, const Study& study,
                  std::chrono::sys_seconds at) {
    SavedResult result = makeSavedResult(project, scenario, study, at);
    return nameResult(std::move(project), name, std::move(result));
}

Project addResult(Project project, const std::string& name, const ImpactAnswer& answer,
                  std::chrono::sys_seconds at) {
    SavedResult result = makeSavedResult(project, answer, at);
    return nameResult(std::move(project), name, std::move(result));
}

Project addResult(Project project, const std::string& name, const ScoreAnswer& answer,
                  std::chrono::sys_seconds at) {
    SavedResult result = makeSavedResult(project, answer, at);
    return nameResult(std::move(project), name, std::move(result));
}

namespace {

void writeTiles(Database& database, const std::string& table, const Grid& grid,
                const std::vector<float>& values) {
    Statement add = database.prepare(fmt::format(
        "INSERT INTO {} (zoom_level, tile_column, tile_row, tile_data) VALUES (0, ?, ?, ?)", table));
    Statement about =
        database.prepare("INSERT INTO gpkg_2d_gridded_tile_ancillary (tpudt_name, tpudt_id) VALUES (?, ?)");
    for (int row = 0; row * tileCells < grid.rows; ++row)
        for (int column = 0; column * tileCells < grid.columns; ++column) {
            const Bytes tile = encodeTile(grid, values, column, row);
            add.run(column, row, AsBlob{tile});
            about.run(table, database.lastRow());
        }
}

void writeLayer(Database& database, const SavedResult& result, std::int64_t id, std::size_t number) {
    const SavedLayer& layer = result.layers[number];
    const std::string table = fmt::format("result_{}_{}", id, number + 1);
    const Grid& grid = result.grid;
    createCoverage(database, {table, fmt::format("{}: {}", result.name, layer.name), layer.unit, grid.westM,
                              grid.northM(), grid.cellM, grid.columns, grid.rows});
    writeTiles(database, table, grid, layer.values);
    database.prepare("INSERT INTO result_layers (result, name, unit, tiles) VALUES (?, ?, ?, ?)")
        .run(id, layer.name, layer.unit, table);
    writeBands(database, result, layer, table);
}

}  // namespace

void writeResult(Database& database, const SavedResult& result) {
    const Grid& grid = result.grid;
    database
        .prepare(
            "INSERT INTO results (name, kind, scenario, baseline, settings, inputs, west_m, south_m, cell_m, "
            "columns, rows) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .run(result.name, result.kind, result.scenario, result.baseline, result.settings, result.inputs,
             grid.westM, grid.southM, grid.cellM, grid.columns, grid.rows);
    const std::int64_t id = database.lastRow();
    for (std::size_t i = 0; i < result.layers.size(); ++i) writeLayer(database, result, id, i);
    writeElements(database, id, result.elements);
}

void removeResult(Database& database, const std::string& name) {
    std::vector<std::string> tables;
    Statement find = database.prepare(
        "SELECT tiles FROM result_layers WHERE result IN (SELECT id FROM results WHERE name = ?)");
    for (find.begin(name); find.step();) tables.push_back(find.text(0));
    for (const std::string& table : tables) {
        dropCoverage(database, table);
        removeBands(database, table);
    }
    database.prepare("DELETE FROM result_elements WHERE result IN (SELECT id FROM results WHERE name = ?)")
        .run(name);
    database.prepare("DELETE FROM result_layers WHERE result IN (SELECT id FROM results WHERE name = ?)")
        .run(name);
    database.prepare("DELETE FROM results WHERE name = ?").run(name);
}

}  // namespace noonmark
