#include <fmt/format.h>
#include <sqlite3.h>

#include "core/io/settings/read_settings.h"
#include "core/study/text/height_facts_text.h"
#include "core/study/text/terrain_text.h"
#include "core/study/tiles/tile_journal.h"
#include "scenarios/project/edit_json.h"
#include "scenarios/project/project_file.h"
#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/weights/time_weights.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/seeds.h"
#include "tests/fuzz/small_project.h"

namespace noonmark::tests {

namespace {

void writeProject(const SeedFolder& seeds, const Project& project) {
    const auto file = seeds.file("project_bytes", "project.noonmark.gpkg");
    require(ProjectFile::create(file, project).has_value(), "a project is written");
    shrink(file);
}

// In the format of fuzz_edit_json: first a digit for the kind.
void writeEdits(const SeedFolder& seeds, const Project& project) {
    constexpr std::string_view kinds[] = {"demolish", "replace", "add", "height", "move", "rotate", "import"};
    for (const Scenario& scenario : project.scenarios)
        for (const Edit& edit : scenario.edits)
            for (std::size_t kind = 0; kind < std::size(kinds); ++kind)
                if (getKind(edit) == kinds[kind])
                    seeds.write("edit_json", std::string(kinds[kind]), std::to_string(kind) + toJson(edit));
}

void writeGeometries(const SeedFolder& seeds, const Project& project) {
    for (const NamedLot& lot : project.lots) seeds.write("geometry_blob", lot.name, polygonBlob(lot.outline));
    for (const Region& region : project.regions)
        seeds.write("geometry_blob", region.name, multiPolygonBlob(region.polygons));
    seeds.write("geometry_blob", "line", lineBlob({{0, 0}, {10.1F, 10}, {10, 0}}));
    seeds.write("geometry_blob", "trees", multiPointBlob({{0, 0}, {10.1F, 10}}));
    seeds.write("geometry_blob", "tangled", polygonBlob({{{0, 0}, {10.1F, 10}, {10, 0}, {0, 9.3F}}, {}}));
}

// One edit of each kind for each column; the first bytes select one of about two hundred columns.
// `before`: what the target reads before the edits.
void writeCellEdits(const SeedFolder& seeds, const std::string& target, int columns,
                    std::string_view before = {}) {
    constexpr std::string_view contents[] = {"",
                                             std::string_view("\1\0\0\0\0\0\0\0", 8),
                                             std::string_view("\0\0\0\0\0\0\xf0\x3f", 8),
                                             "text",
                                             "blob",
                                             std::string_view("\7\0\2[]", 5),
                                             "",
                                             ""};
    for (int column = 0; column < columns; ++column)
        for (std::size_t kind = 0; kind < std::size(contents); ++kind) {
            std::string edit(before);
            put(edit, std::uint16_t(column));
            put(edit, std::uint8_t(kind));
            put(edit, std::uint8_t(contents[kind].size()));
            seeds.write(target, fmt::format("{}{}-{}", before, column, kind), edit.append(contents[kind]));
        }
}

void writeTexts(const SeedFolder& seeds, const Project& project) {
    seeds.write("weights_csv", "months", weightsCsv(makeMonthlyWeights()));
    seeds.write("weights_csv", "school", weightsCsv(project.weights.back()));
    seeds.write("weights_json", "months", weightsJson(makeMonthlyWeights()));
    seeds.write("weights_json", "school", weightsJson(project.weights.back()));
    seeds.write("reading_text", "settings", formatText(*project.reading->settings));
    seeds.write("reading_text", "terrain", sourceText(*project.city->terrain));
    seeds.write("reading_text", "heights", heightFactsJson(project.reading->heights).dump());
    TileResult tile{.number = 1, .engineKey = "ray", .engine = "rays"};
    tile.compared = {{{1, 2}, 3, 4, 5, 6}};
    seeds.write("tile_journal", "tiles", toJson(tile).dump() + "\n" + toJson(TileResult{}).dump());
}

}  // namespace

void shrink(const std::filesystem::path& database) {
    sqlite3* open = nullptr;
    sqlite3_open(database.c_str(), &open);
    sqlite3_exec(open, "PRAGMA page_size = 512; VACUUM", nullptr, nullptr, nullptr);
    sqlite3_close(open);
}

void makeProjectSeeds(const SeedFolder& seeds) {
    const Project project = smallProject();
    writeProject(seeds, project);
    writeEdits(seeds, project);
    writeGeometries(seeds, project);
    writeTexts(seeds, project);
    writeCellEdits(seeds, "project_cells", 220);
    for (const std::string_view version :
         {"0", "1", "2", "3", "4"})  // any byte selects one, by its remainder
        writeCellEdits(seeds, "project_versions", 190, version);
    writeCellEdits(seeds, "geopackage_cells", 50);
}

}  // namespace noonmark::tests
