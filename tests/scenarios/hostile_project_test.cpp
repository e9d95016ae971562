// Hostile project files: any number, table or statement in them may be malicious.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <chrono>
#include <fstream>
#include <random>

#include "scenarios/project/edit_json.h"
#include "scenarios/project/project_file.h"
#include "scenarios/project/results/saved_answer.h"
#include "scenarios/project/tables/database.h"
#include "tests/core/io/planted_journal.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/scenarios/sample_project.h"

namespace noonmark::tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Rows of text; empty for statements that return no rows.
using Rows = std::vector<std::vector<std::string>>;

int keepRow(void* rows, int columns, char** values, char**) {
    auto& row = static_cast<Rows*>(rows)->emplace_back();
    for (int i = 0; i < columns; ++i) row.emplace_back(values[i] != nullptr ? values[i] : "");
    return 0;
}

class HostileProject : public testing::Test {
protected:
    void SetUp() override { remake(); }

    void remake() {
        fs::remove(file());
        ASSERT_TRUE(ProjectFile::create(file(), sampleProject()));
    }
    [[nodiscard]] fs::path file() const { return folder_.path("town.noonmark.gpkg"); }

    /// Executes statements as any SQLite program would; refused statements change nothing.
    Rows sql(const std::string& statements) const {
        sqlite3* database = nullptr;
        sqlite3_open(file().c_str(), &database);
        Rows rows;
        sqlite3_exec(database, statements.c_str(), keepRow, &rows, nullptr);
        sqlite3_close(database);
        return rows;
    }

    /// The error of opening the file; empty if it opens.
    [[nodiscard]] std::string error() const {
        const auto opened = ProjectFile::open(file());
        return opened ? "" : opened.error().text();
    }

    void expectRefused(const std::string& statements, const std::string& about) {
        sql(statements);
        EXPECT_THAT(error(), HasSubstr(about)) << statements;
        remake();
    }

    TemporaryFolder folder_;
};

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

struct PlantedJournal : HostileProject {
    void SetUp() override {
        HostileProject::SetUp();
        victim = folder_.file("thesis.txt", "years of work");
    }
    void expectUnharmed() const { EXPECT_EQ(allBytes(victim), "years of work"); }
    [[nodiscard]] fs::path beside(const char* ending) const { return file().string() + ending; }

    fs::path victim;
};

TEST_F(PlantedJournal, ThatNamesAFileDeletesNothingAndIsRefused) {
    auto opened = ProjectFile::open(file());
    ASSERT_TRUE(opened);
    const std::string before = allBytes(file());
    plantJournal(file(), victim);
    EXPECT_THAT(error(), HasSubstr("names another file"));
    const auto saved = opened->save(opened->project());
    ASSERT_FALSE(saved);
    EXPECT_THAT(saved.error().text(), HasSubstr("names another file"));
    EXPECT_FALSE(opened->isUnchanged());
    EXPECT_TRUE(fs::exists(beside("-journal")));
    EXPECT_EQ(allBytes(file()), before);
    expectUnharmed();
}

TEST_F(PlantedJournal, ThatNamesTheJournalOfAnotherProjectLeavesThatAlone) {
    const fs::path other = folder_.path("other.noonmark.gpkg");
    fs::copy_file(file(), other);
    plantJournal(other);
    plantJournal(file(), other.string() + "-journal");
    EXPECT_THAT(error(), HasSubstr("names another file"));
    EXPECT_TRUE(fs::exists(other.string() + "-journal"));
}

// What a program that swaps the journal after the check would meet.
TEST_F(PlantedJournal, ReachesNoOtherFileThroughAConnection) {
    plantJournal(file(), victim);
    for (const auto access : {Database::Access::write, Database::Access::read})
        EXPECT_THROW((void)Database(file(), access).value("SELECT count(*) FROM noonmark"), DatabaseError);
    expectUnharmed();
}

TEST_F(PlantedJournal, BesideARecoveryFileDeletesNothing) {
    const fs::path recovery = recoveryPath(file());
    fs::copy_file(file(), recovery);
    plantJournal(recovery, victim);
    const auto recovered = ProjectFile::open(recovery);
    ASSERT_FALSE(recovered);
    EXPECT_THAT(recovered.error().text(), HasSubstr("names another file"));
    expectUnharmed();
}

TEST_F(PlantedJournal, OfAKilledSaveIsStillRolledBack) {
    plantJournal(file());
    EXPECT_EQ(error(), "");
    EXPECT_FALSE(fs::exists(beside("-journal")));
}

TEST_F(PlantedJournal, ThatStatesASizeTheFileNeverHadIsRefused) {
    plantJournal(file());
    std::string journal = allBytes(beside("-journal"));
    journal.replace(16, 4, bigEndian(0x7fffffff));  // pages of the database before the transaction
    std::ofstream(beside("-journal"), std::ios::binary) << journal;
    const auto before = fs::file_size(file());
    EXPECT_THAT(error(), HasSubstr("a size that the file never had"));
    EXPECT_EQ(fs::file_size(file()), before);
}

TEST_F(PlantedJournal, OrLogThatIsALinkIsRefused) {
    for (const char* ending : {"-journal", "-wal", "-shm"}) {
        fs::create_symlink(victim, beside(ending));
        EXPECT_THAT(error(), HasSubstr("a link")) << ending;
        fs::remove(beside(ending));
    }
    expectUnharmed();
}

TEST_F(PlantedJournal, OfAnOlderFileIsNotAppliedToANewOne) {
    plantJournal(file());
    fs::remove(file());
    EXPECT_FALSE(ProjectFile::create(file(), sampleProject()));
    const fs::path recovery = recoveryPath(file());
    fs::rename(beside("-journal"), recovery.string() + "-journal");
    Project project = sampleProject();
    for (int i = 0; i < 200; ++i) project.lots.push_back({"lot " + std::to_string(i), box(0, 0, 9, 9)});
    Autosave autosave(file());
    ASSERT_TRUE(autosave.keep(project));
    const auto recovered = ProjectFile::open(recovery);
    ASSERT_TRUE(recovered) << recovered.error().text();
    EXPECT_EQ(recovered->project().lots, project.lots);
    plantJournal(recovery);
    autosave.discard();
    EXPECT_THAT(folder_.names(), testing::ElementsAre("thesis.txt"));
}

TEST_F(PlantedJournal, MovesWithItsRecoveryFile) {
    plantJournal(file());
    const fs::path aside = folder_.path("aside.noonmark.gpkg");
    moveProject(file(), aside);
    EXPECT_TRUE(fs::exists(aside.string() + "-journal"));
    EXPECT_TRUE(ProjectFile::open(aside));
    EXPECT_THAT(folder_.names(), testing::ElementsAre("aside.noonmark.gpkg", "thesis.txt"));
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
