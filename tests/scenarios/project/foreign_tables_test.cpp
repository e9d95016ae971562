// Project files whose tables other programs changed: triggers, views, constraints, columns, indexes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "scenarios/project/edit_json.h"
#include "tests/scenarios/project/hostile_project.h"

namespace noonmark::tests {
namespace {

using testing::HasSubstr;

TEST_F(HostileProject, TriggersDoNotRun) {
    sql("CREATE TRIGGER empty AFTER INSERT ON scenarios BEGIN DELETE FROM buildings; END;"
        "CREATE TRIGGER again AFTER UPDATE ON noonmark BEGIN DELETE FROM buildings; DELETE FROM edits; END;");
    auto opened = ProjectFile::open(file());
    ASSERT_TRUE(opened) << opened.error().text();
    Project project = opened->project();
    project.scenarios.push_back({"C", "", {}});
    ASSERT_TRUE(opened->save(project));
    const auto after = ProjectFile::open(file());
    ASSERT_TRUE(after) << after.error().text();
    EXPECT_TRUE(sameCity(*after->project().city, *project.city));
    EXPECT_EQ(after->project().scenarios.back().name, "C");
}

TEST_F(HostileProject, ViewsInPlaceOfTablesAreRefusedAtOnce) {
    const auto start = std::chrono::steady_clock::now();
    const std::string endless =
        " AS WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n) SELECT x AS id, ";
    expectRefused(
        "DROP TABLE inputs; CREATE VIEW inputs" + endless + "'a' AS path, 1 AS bytes, '' AS sha256 FROM n;",
        "damaged");
    expectRefused("DROP TABLE noonmark; CREATE VIEW noonmark" + endless +
                      "'schema_version' AS key, '1' AS value FROM n;",
                  "not a Noonmark project");
    expectRefused("DROP TABLE result_1_1; CREATE VIEW result_1_1" + endless +
                      "0 AS zoom_level, 0 AS tile_column, 0 AS tile_row, x'' AS tile_data FROM n;",
                  "damaged");
    expectRefused("DROP TABLE inputs; CREATE VIRTUAL TABLE inputs USING fts5(id, path, bytes, sha256)",
                  "not a table");
    expectRefused(
        "DROP TABLE inputs; CREATE TABLE inputs (id INTEGER PRIMARY KEY, path AS (hex(randomblob(9))), "
        "bytes, "
        "sha256)",
        "damaged");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST_F(HostileProject, ASpatialIndexThatAGisAddedDoesNotStandInTheWay) {
    sql("CREATE VIRTUAL TABLE rtree_lots_geom USING rtree(id, minx, maxx, miny, maxy);"
        "CREATE TRIGGER rtree_lots_geom_insert AFTER INSERT ON lots BEGIN INSERT INTO rtree_lots_geom VALUES "
        "(NEW.fid, "
        "ST_MinX(NEW.geom), 1, 0, 1); END;"
        "INSERT INTO gpkg_extensions VALUES ('lots', 'geom', 'gpkg_rtree_index', '', 'write-only');");
    auto opened = ProjectFile::open(file());
    ASSERT_TRUE(opened) << opened.error().text();
    Project project = opened->project();
    project.lots.pop_back();
    const auto saved = opened->save(project);
    ASSERT_TRUE(saved) << saved.error().text();
    EXPECT_EQ(ProjectFile::open(file()).value().project().lots, project.lots);
    EXPECT_THAT(sql("SELECT name FROM sqlite_master WHERE name LIKE 'rtree%'"), testing::IsEmpty());
    EXPECT_THAT(sql("SELECT 1 FROM gpkg_extensions WHERE extension_name = 'gpkg_rtree_index'"),
                testing::IsEmpty());
}

// Trees and the map context, too, which came with later versions of the file.
TEST_F(HostileProject, SpatialIndexesOfAllLayersAreRemovedBeforeASave) {
    const auto layers = sql("SELECT table_name FROM gpkg_geometry_columns");
    EXPECT_GE(layers.size(), 8U);
    for (const std::string layer :
         {"buildings", "proposals", "lots", "regions", "places", "context", "trees", "result_elements"})
        sql(
            fmt::format("CREATE VIRTUAL TABLE rtree_{0}_geom USING rtree(id, minx, maxx, miny, maxy);"
                        "INSERT INTO gpkg_extensions VALUES ('{0}', 'geom', 'gpkg_rtree_index', '', '');",
                        layer));
    ASSERT_EQ(sql("SELECT 1 FROM gpkg_extensions WHERE extension_name = 'gpkg_rtree_index'").size(), 8U);
    auto opened = ProjectFile::open(file());
    ASSERT_TRUE(opened) << opened.error().text();
    const auto saved = opened->save(opened->project());
    ASSERT_TRUE(saved) << saved.error().text();
    EXPECT_THAT(sql("SELECT name FROM sqlite_master WHERE name LIKE 'rtree%'"), testing::IsEmpty());
    EXPECT_THAT(sql("SELECT 1 FROM gpkg_extensions WHERE extension_name = 'gpkg_rtree_index'"),
                testing::IsEmpty());
}

// Every scenario with its edits, which hold their shapes by pointer.
std::vector<std::string> textsOf(const std::vector<Scenario>& scenarios) {
    std::vector<std::string> texts;
    for (const Scenario& scenario : scenarios) {
        texts.push_back(scenario.name + " from " + scenario.base);
        for (const Edit& edit : scenario.edits)
            texts.push_back(std::string(getKind(edit)) + ' ' + toJson(edit));
    }
    return texts;
}

// Replaces a table by one with the same rows and other columns.
std::string rebuilt(const std::string& table, const std::string& columns) {
    return fmt::format(
        "ALTER TABLE {0} RENAME TO old; CREATE TABLE {0} ({1}); INSERT INTO {0} SELECT * FROM old; "
        "DROP TABLE old;",
        table, columns);
}

TEST_F(HostileProject, ConstraintsOfOthersMakeASaveLoseNothing) {
    const std::string id = "id INTEGER PRIMARY KEY NOT NULL, ";
    const std::string edit = id + "scenario INTEGER NOT NULL, position INTEGER NOT NULL, kind TEXT NOT NULL";
    for (const std::string& change :
         {std::string("CREATE UNIQUE INDEX one ON scenarios (base)"),
          std::string("CREATE UNIQUE INDEX one ON edits (kind)"),
          rebuilt("scenarios", id + "name TEXT NOT NULL, base TEXT NOT NULL UNIQUE ON CONFLICT REPLACE"),
          rebuilt("scenarios",
                  id + "name TEXT NOT NULL, base TEXT NOT NULL, UNIQUE (base) ON CONFLICT IGNORE"),
          rebuilt("scenarios", id + "name INTEGER NOT NULL, base TEXT NOT NULL"),
          rebuilt("edits", edit + " UNIQUE ON CONFLICT IGNORE, words TEXT NOT NULL, value TEXT NOT NULL"),
          rebuilt("scenarios", id + "name TEXT NOT NULL CHECK (name <> 'C'), base TEXT NOT NULL")}) {
        SCOPED_TRACE(change);
        sql(change + ";");
        auto opened = ProjectFile::open(file());
        ASSERT_TRUE(opened) << opened.error().text();
        Project project = opened->project();
        project.scenarios.push_back({"C", "", {Demolish{"a"}}});
        project.scenarios.push_back({"007", "", {Demolish{"b"}, ChangeHeight{"c", 8}}});
        project.weights.push_back({"more", project.weights.front().intervals});
        const auto saved = opened->save(project);
        ASSERT_TRUE(saved) << saved.error().text();
        const auto after = ProjectFile::open(file());
        ASSERT_TRUE(after) << after.error().text();
        EXPECT_EQ(textsOf(after->project().scenarios), textsOf(project.scenarios));
        EXPECT_EQ(after->project().weights, project.weights);
        remake();
    }
}

TEST_F(HostileProject, ColumnsThatAGisAddedStayWhenATableIsTakenBack) {
    sql("ALTER TABLE lots ADD COLUMN \"my remark\" TEXT(50); UPDATE lots SET \"my remark\" = 'sunny';"
        "CREATE UNIQUE INDEX one ON lots (name);");
    sql("ALTER TABLE edits ADD COLUMN note TEXT; UPDATE edits SET note = 'by hand'; CREATE UNIQUE INDEX two "
        "ON "
        "edits (kind);");
    sql(rebuilt("regions",
                "fid INTEGER PRIMARY KEY NOT NULL, geom BLOB, name TEXT UNIQUE ON CONFLICT IGNORE, "
                "area_m2 REAL"));
    sql("ALTER TABLE regions ADD COLUMN rank INTEGER DEFAULT 7; ALTER TABLE regions ADD COLUMN more;");
    auto opened = ProjectFile::open(file());
    ASSERT_TRUE(opened) << opened.error().text();
    Project project = opened->project();
    project.view["turn"] = "1";
    ASSERT_TRUE(opened->save(project));
    EXPECT_EQ(sql("SELECT \"my remark\" FROM lots")[0][0], "sunny");
    EXPECT_EQ(sql("SELECT rank FROM regions")[0][0], "7");
    EXPECT_EQ(sql("SELECT note FROM edits")[0][0], "by hand");
    EXPECT_THAT(sql("SELECT 1 FROM sqlite_master WHERE name = 'one'"), testing::IsEmpty());
    EXPECT_THAT(sql("SELECT sql FROM sqlite_master WHERE name = 'regions'")[0][0],
                testing::Not(HasSubstr("CONFLICT")));
}

TEST_F(HostileProject, ScenariosThatAnotherProgramNumberedAreSavedUnderTheirOwnNumbers) {
    sql("UPDATE scenarios SET id = id + 10; UPDATE edits SET scenario = scenario + 10;");
    auto opened = ProjectFile::open(file());
    ASSERT_TRUE(opened) << opened.error().text();
    Project project = opened->project();
    project.scenarios[0].edits.pop_back();
    ASSERT_TRUE(opened->save(project));
    const auto after = ProjectFile::open(file());
    ASSERT_TRUE(after) << after.error().text();
    EXPECT_EQ(textsOf(after->project().scenarios), textsOf(project.scenarios));
}

TEST_F(HostileProject, BuildingsUnderOtherNumbersAreRefused) {
    expectRefused("UPDATE buildings SET building = building + 1", "buildings are missing");
}

}  // namespace
}  // namespace noonmark::tests
