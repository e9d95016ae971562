#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "scenarios/project/tables/schema.h"

// Holds the tables of a file against those that this program creates, and makes them so again.
namespace noonmark {

namespace {

struct OurTable {
    std::vector<std::string> columns;
    std::string sql;
};
using Texts = std::map<std::string, std::string>;
struct OurSchema {
    std::map<std::string, OurTable> tables;
    Texts indexes;  // SQL by name
};

// As this program creates them.
const OurSchema& ourSchema() {
    static const OurSchema schema = [] {
        OurSchema made;
        Database memory(":memory:", Database::Access::create);
        createSchema(memory, "");
        Statement entry = memory.prepare(
            "SELECT type, name, sql FROM sqlite_master WHERE sql IS NOT NULL AND name NOT LIKE 'sqlite%'");
        while (entry.step())
            (entry.text(0) == "table" ? made.tables[entry.text(1)].sql : made.indexes[entry.text(1)]) =
                entry.text(2);
        Statement column = memory.prepare("SELECT name FROM pragma_table_info(?)");
        for (auto& [name, table] : made.tables)
            for (column.begin(name); column.step();) table.columns.push_back(column.text(0));
        return made;
    }();
    return schema;
}

// What the GeoPackage standard and QGIS define is read by others; the program does not depend on it.
bool isRead(const std::string& table) { return !table.starts_with("gpkg_") && table != "layer_styles"; }

std::string quoted(const std::string& name) {
    std::string text = "\"";
    for (const char letter : name) text += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return text + '"';
}

bool isSpace(char letter) { return letter == ' ' || letter == '\n' || letter == '\t' || letter == '\r'; }

// Without the spaces that mean nothing in SQL.
std::string squeezed(std::string_view sql) {
    constexpr std::string_view alone = "(),";
    std::string text;
    bool space = false;
    for (const char letter : sql) {
        if (isSpace(letter)) {
            space = true;
            continue;
        }
        const bool apart =
            text.empty() || alone.find(text.back()) != alone.npos || alone.find(letter) != alone.npos;
        if (space && !apart) text += ' ';
        space = false;
        text += letter;
    }
    return text;
}

struct AddedColumn {
    std::string name, type;
};

// The column types of the GeoPackage standard, which may state a length: "TEXT(50)". Any other could be SQL,
// and gives a column without a type, which holds every value as it is.
std::string plainType(const std::string& type) {
    constexpr std::array known{"BOOLEAN", "TINYINT", "SMALLINT", "MEDIUMINT", "INT",  "INTEGER", "FLOAT",
                               "DOUBLE",  "REAL",    "TEXT",     "BLOB",      "DATE", "DATETIME"};
    const auto bar = std::min(type.find('('), type.size());
    const std::string length = type.substr(bar);
    const bool isLength = length.empty() || (length.back() == ')' && length.size() > 2 &&
                                             length.find_first_not_of("0123456789", 1) == length.size() - 1);
    return isLength && std::ranges::find(known, type.substr(0, bar)) != known.end() ? type : std::string();
}

bool isSameName(const std::string& a, const std::string& b) {  // as SQLite compares them
    const auto small = [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? char(letter + 32) : letter;
    };
    return std::ranges::equal(a, b, {}, small, small);
}

std::vector<AddedColumn> addedColumns(Database& database, const std::string& table, const OurTable& ours) {
    std::vector<AddedColumn> added;
    Statement column = database.prepare("SELECT name, type FROM pragma_table_xinfo(?) WHERE hidden = 0");
    for (column.begin(table); column.step();) {
        const auto isThis = [&](const std::string& name) { return isSameName(name, column.text(0)); };
        if (std::ranges::none_of(ours.columns, isThis))
            added.push_back({column.text(0), plainType(column.text(1))});
    }
    return added;
}

std::string sqlOf(Database& database, const std::string& table) {
    Statement found = database.prepare("SELECT sql FROM sqlite_master WHERE type = 'table' AND name = ?");
    found.begin(table);
    return found.step() ? found.text(0) : std::string();
}

// SQLite itself finds the place of added columns, which come before the constraints of a table.
std::string sqlWith(const std::string& table, const OurTable& ours, const std::vector<AddedColumn>& added) {
    if (added.empty()) return ours.sql;
    Database memory(":memory:", Database::Access::create);
    memory.execute(ours.sql);
    for (const AddedColumn& column : added)
        memory.execute(
            fmt::format("ALTER TABLE {} ADD COLUMN {} {}", table, quoted(column.name), column.type));
    return sqlOf(memory, table);
}

std::string columnList(const OurTable& ours, const std::vector<AddedColumn>& added) {
    std::string list;
    for (const std::string& name : ours.columns) list += quoted(name) + ", ";
    for (const AddedColumn& column : added) list += quoted(column.name) + ", ";
    return list.substr(0, list.size() - 2);
}

// Dropping a table drops its indexes and triggers.
void takeTableBack(Database& database, const std::string& table, const OurTable& ours) {
    const std::string sql = sqlOf(database, table);
    const auto added = addedColumns(database, table, ours);
    if (sql.empty() || squeezed(sql) == squeezed(sqlWith(table, ours, added))) return;
    const std::string columns = columnList(ours, added);
    database.execute(fmt::format("CREATE TEMP TABLE taken AS SELECT {} FROM main.{}", columns, table));
    database.execute(fmt::format("DROP TABLE main.{}; {}", table, sqlWith(table, ours, added)));
    database.execute(fmt::format("INSERT INTO main.{0} ({1}) SELECT {1} FROM temp.taken", table, columns));
    database.execute("DROP TABLE temp.taken");
}

void takeIndexesBack(Database& database) {
    const OurSchema& ours = ourSchema();
    std::vector<std::string> foreign;
    Texts missing = ours.indexes;
    Statement index = database.prepare(
        "SELECT name, tbl_name, sql FROM sqlite_master WHERE type = 'index' AND sql IS NOT NULL");
    while (index.step()) {
        const auto known = missing.find(index.text(0));
        if (known != missing.end() && squeezed(known->second) == squeezed(index.text(2)))
            missing.erase(known);
        else if (ours.tables.contains(index.text(1)))
            foreign.push_back(index.text(0));
    }
    for (const std::string& name : foreign) database.execute("DROP INDEX main." + quoted(name));
    for (const auto& [name, sql] : missing) database.execute(sql);
}

void removeSpatialIndex(Database& database, const std::string& table) {
    const std::string index = fmt::format("rtree_{}_geom", table);
    std::vector<std::string> statements;
    Statement found = database.prepare(
        "SELECT printf('DROP %s IF EXISTS \"%w\"', type, name) FROM sqlite_master WHERE (type = "
        "'trigger' AND "
        "tbl_name = ?1 COLLATE NOCASE AND substr(name, 1, length(?2)) = ?2) OR (type = 'table' AND name "
        "= ?2)");
    for (found.begin(table, index); found.step();) statements.push_back(found.text(0));
    if (statements.empty()) return;
    for (const std::string& statement : statements) database.execute(statement);
    database
        .prepare("DELETE FROM gpkg_extensions WHERE table_name = ? AND extension_name = 'gpkg_rtree_index'")
        .run(table);
}

}  // namespace

void checkTable(Database& database, const std::string& table, const std::vector<std::string>& columns) {
    Statement kind = database.prepare(
        "SELECT 1 FROM pragma_table_list WHERE schema = 'main' AND name = ? AND type = 'table'");
    kind.begin(table);
    if (!kind.step()) throwDamaged(fmt::format("'{}' is not a table", table));
    std::set<std::string> found;
    Statement column = database.prepare("SELECT name FROM pragma_table_xinfo(?) WHERE hidden = 0");
    for (column.begin(table); column.step();) found.insert(column.text(0));
    for (const std::string& name : columns)
        if (!found.contains(name)) throwDamaged(fmt::format("table {} has no column {}", table, name));
}

void checkTables(Database& database) {
    for (const auto& [name, table] : ourSchema().tables)
        if (isRead(name)) checkTable(database, name, table.columns);
}

void restoreTableDefinitions(Database& database) {
    for (const auto& [name, table] : ourSchema().tables) takeTableBack(database, name, table);
    takeIndexesBack(database);
}

void removeSpatialIndexes(Database& database) {
    for (const auto& [name, table] : ourSchema().tables)
        if (std::ranges::find(table.columns, "geom") != table.columns.end())
            removeSpatialIndex(database, name);
}

}  // namespace noonmark
