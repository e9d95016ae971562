// Hostile project files: any number, table or statement in them may be malicious.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <random>

#include "scenarios/project/results/saved_answer.h"
#include "scenarios/project/tables/database.h"
#include "tests/scenarios/project/hostile_project.h"

namespace noonmark::tests {
namespace {

namespace fs = std::filesystem;

TEST_F(HostileProject, TitleBlocksAreChecked) {
    expectRefused("UPDATE sheet_settings SET value = 'furlongs' WHERE key = 'units'", "units");
    expectRefused("UPDATE sheet_settings SET value = 'GIF89a' WHERE key = 'logo'", "logo");
    expectRefused("UPDATE sheet_settings SET value = zeroblob(2000000) WHERE key = 'logo'", "logo");
    expectRefused("UPDATE sheet_settings SET value = printf('%.*c', 801, 'x') WHERE key = 'author'",
                  "title block");
    expectRefused("UPDATE sheet_settings SET value = 'a' || char(10) || 'b' WHERE key = 'client'",
                  "title block");
}

TEST_F(HostileProject, NumbersAreCheckedWhereTheyEnter) {
    expectRefused("UPDATE terrain SET elevations_m = x''", "terrain, row 1: elevations_m");
    expectRefused("UPDATE terrain SET elevations_m = x'00000000'", "terrain, row 1: elevations_m");
    for (const char* column : {"columns", "rows"})
        for (const char* value : {"-3", "0", "2147483648", "1e300", "'many'", "2.5"})
            for (const std::string table : {"terrain", "results"})
                expectRefused("UPDATE " + table + " SET " + column + " = " + value, column);
    expectRefused("UPDATE terrain SET columns = -1, rows = 0, elevations_m = x''", "columns");
    expectRefused("UPDATE results SET columns = 100000, rows = 100000", "cells");
    for (const char* value : {"0", "-1", "1e-300", "1e300", "9e999", "'x'"})
        for (const std::string table : {"terrain", "results"})
            expectRefused("UPDATE " + table + " SET cell_m = " + value, "cell_m");
    for (const char* value : {"9e999", "-9e999", "1e300", "'x'"}) {
        expectRefused(std::string("UPDATE terrain SET west_m = ") + value, "west_m");
        expectRefused(std::string("UPDATE results SET south_m = ") + value, "south_m");
        expectRefused(std::string("UPDATE buildings SET top_m = ") + value, "top_m");
        expectRefused(std::string("UPDATE buildings SET bottom_m = ") + value, "bottom_m");
    }
    expectRefused("UPDATE buildings SET top_m = bottom_m", "height");
    for (const char* value : {"nan", "inf", "1e300", "", "91.5"})
        expectRefused(std::string("UPDATE noonmark SET value = '") + value + "' WHERE key = 'origin_lat_deg'",
                      "origin_lat_deg");
    // Three float32 bit patterns: NaN, infinity, 1e38.
    for (const char* bytes : {"0000c07f", "0000807f", "997696 7e"}) {
        std::string blob;
        for (int i = 0; i < 360; ++i)
            for (const char* at = bytes; *at != '\0'; ++at)
                if (*at != ' ') blob += *at;
        expectRefused("UPDATE terrain SET elevations_m = x'" + blob + "'", "elevation");
    }
}

TEST_F(HostileProject, MeshesOutlinesAndTilesAreChecked) {
    expectRefused("UPDATE meshes SET vertices = x'', triangles = x''", "meshes");
    expectRefused("UPDATE meshes SET vertices = zeroblob(length(vertices) - 1)", "cut off");
    expectRefused("UPDATE meshes SET triangles = x'FFFFFFFFFFFFFFFFFFFFFFFF'", "vertex");
    expectRefused(
        "UPDATE meshes SET vertices = x'0000C07F0000C07F0000C07F', triangles = x'000000000000000000000000'",
        "meshes");
    for (const std::string table : {"buildings", "lots", "regions"}) {
        expectRefused("UPDATE " + table + " SET geom = x''", "outline");
        expectRefused("UPDATE " + table + " SET geom = zeroblob(200)", "outline");
        expectRefused("UPDATE " + table + " SET geom = substr(geom, 1, length(geom) - 20)", "outline");
    }
    for (const char* column : {"tile_column", "tile_row"})
        for (const char* value : {"-1", "-5000", "2000000000", "4294967296", "'x'"})
            expectRefused("UPDATE result_1_1 SET " + std::string(column) + " = " + value + " WHERE id = 1",
                          column);
    expectRefused("UPDATE result_1_1 SET tile_data = zeroblob(1000)", "tile");
}

TEST_F(HostileProject, PeriodsWeightsAndEditsAreChecked) {
    for (const char* change : {"first_month = 257", "first_month = 0", "last_day = 99", "from_min = -5",
                               "to_min = 1e10", "weight = 9e999", "weight = 'heavy'"})
        expectRefused(std::string("UPDATE time_weights SET ") + change, "time_weights");
    for (const char* settings :
         {R"({"days":0})", R"({"days":1e12})", R"({"hours":-1})", R"({"step_min":0})",
          R"({"step_min":1e-300})", R"({"from":"99999999999"})", R"({"window":"sunrise+1000h..sunset"})",
          R"({"start":"May"})", R"({"zone":7})", "[]", "{", "", "nonsense"})
        expectRefused(std::string("UPDATE periods SET settings = '") + settings + "'", "periods");
    expectRefused("UPDATE periods SET settings = NULL", "periods");
    for (const char* value : {R"({"building":"c","height_m":1e300})", R"({"building":"c","height_m":1e999})",
                              R"({"building":"c","height_m":"tall"})", "{", "[]", "nonsense"})
        expectRefused(std::string("UPDATE edits SET value = '") + value + "' WHERE kind = 'height'", "edit");
    expectRefused(
        R"(UPDATE edits SET value = replace(value, '"parts":[', '"parts":[],"x":[') WHERE kind = 'add')",
        "edit");
    expectRefused(
        R"(UPDATE edits SET value = replace(value, '"scale":1.5', '"scale":0') WHERE kind = 'import')",
        "edit");
    expectRefused(R"(UPDATE edits SET value = replace(value, '200.0', '1e30') WHERE kind = 'add')", "edit");
}

TEST_F(HostileProject, AResultNamesNoTableOfTheProject) {
    for (const char* table :
         {"buildings", "result_1_1; DROP TABLE edits", "result_", "result_1_", "result__1", "noonmark"})
        expectRefused(std::string("UPDATE result_layers SET tiles = '") + table + "' WHERE id = 1",
                      "not a table of a result");
}

TEST_F(HostileProject, LongChainsOfScenariosAreRefusedAtOnce) {
    const auto start = std::chrono::steady_clock::now();
    expectRefused(
        "DELETE FROM edits; DELETE FROM scenarios; WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 "
        "FROM "
        "n LIMIT 100000) INSERT INTO scenarios SELECT x, 's' || x, iif(x > 1, 's' || (x - 1), '') FROM n;",
        "scenarios");
    expectRefused(
        "DELETE FROM edits; DELETE FROM scenarios; WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 "
        "FROM "
        "n LIMIT 5000) INSERT INTO scenarios SELECT x, 's' || x, iif(x > 1, 's' || (x - 1), '') FROM n;",
        "bases");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

// Uses everything in a file that opens: computes cities, reads results and saves the project.
void useAll(const fs::path& file) {
    auto opened = ProjectFile::open(file);
    if (!opened) {
        EXPECT_FALSE(opened.error().what.empty());
        return;
    }
    const Project project = opened->project();
    for (const Scenario& scenario : project.scenarios)
        if (const auto made = cityOf(project, scenario.name); made)
            for (const auto& building : made->city.buildings)
                for (const Part& part : building->parts) {
                    ASSERT_GE(part.footprint.outer.size(), 3U);
                }
    for (const auto& result : project.results) (void)readSavedAnswer(*result);
    if (project.city->terrain) {
        ASSERT_EQ(project.city->terrain->elevationM.size(), project.city->terrain->grid.size());
        EXPECT_TRUE(std::isfinite(elevationAt(*project.city->terrain, {1, 1})));
    }
    Project changed = project;
    changed.scenarios.push_back({"one more", "", {}});
    (void)opened->save(changed);
}

TEST_F(HostileProject, ChangedCellsNeverCrash) {
    std::vector<std::pair<std::string, std::string>> cells;
    for (const auto& row :
         sql("SELECT t.name, c.name FROM sqlite_master t, pragma_table_info(t.name) c WHERE t.type = "
             "'table' AND t.name NOT LIKE 'gpkg%' AND t.name NOT LIKE 'sqlite%' AND t.name NOT LIKE "
             "'%bands' AND t.name NOT IN ('layer_styles', 'proposals')"))
        cells.emplace_back(row[0], row[1]);
    ASSERT_GT(cells.size(), 60U);
    const std::string whole = readBytes(file());
    const std::vector<std::string> values{"NULL",
                                          "0",
                                          "-1",
                                          "1",
                                          "2147483648",
                                          "-9223372036854775808",
                                          "1e300",
                                          "-1e300",
                                          "9e999",
                                          "1e-300",
                                          "0.5",
                                          "''",
                                          "'x'",
                                          "x''",
                                          "x'00'",
                                          "zeroblob(500)",
                                          "randomblob(60)",
                                          "printf('%.*c', 3000, '[')",
                                          "'Existing'",
                                          "'{}'",
                                          "'NaN'"};
    std::mt19937 random(20261122);
    const auto any = [&](const auto& list) { return list[random() % list.size()]; };
    for (int round = 0; round < 400; ++round) {
        std::ofstream(file(), std::ios::binary | std::ios::trunc) << whole;
        for (int i = 0; i < 1 + int(random() % 2); ++i) {
            const auto [table, column] = any(cells);
            // A blob keeps most of its bytes; other values are replaced.
            const std::string flipped = fmt::format(
                "CASE typeof({0}) WHEN 'blob' THEN cast(substr(cast({0} AS blob), 1, {1}) || "
                "randomblob(1) || substr(cast({0} AS blob), {1} + 2) AS blob) ELSE {2} END",
                column, 1 + random() % 60, any(values));
            const std::string value = random() % 2 == 0 ? flipped : any(values);
            sql(fmt::format("UPDATE OR IGNORE \"{}\" SET {} = {}{}", table, column, value,
                            random() % 2 == 0 ? "" : " WHERE rowid % 2 = 1"));
        }
        SCOPED_TRACE(round);
        useAll(file());
    }
}

TEST_F(HostileProject, ResultsTakeNoMemoryThatTheirTilesDoNotExplain) {
    expectRefused("DELETE FROM result_1_1", "tiles are missing");
    expectRefused("UPDATE results SET columns = 15000, rows = 15000", "tiles are missing");
}

TEST_F(HostileProject, AValueLargerThanTheFileIsNotMade) {
    Database database(file(), Database::Access::read);
    database.limitValues(file());
    EXPECT_THROW((void)database.value("SELECT length(hex(zeroblob(400000000)))"), DatabaseError);
}

}  // namespace
}  // namespace noonmark::tests
