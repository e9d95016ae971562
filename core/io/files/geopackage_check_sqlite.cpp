#include <fmt/format.h>
#include <sqlite3.h>

#include <array>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/stop_scope.h"
#include "core/io/files/geopackage_check.h"

namespace noonmark {

namespace {

struct CloseDatabase {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
};
struct EndStatement {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using OpenFile = std::unique_ptr<sqlite3, CloseDatabase>;
using Query = std::unique_ptr<sqlite3_stmt, EndStatement>;

bool isDatabase(const std::filesystem::path& file) {
    constexpr std::string_view magic("SQLite format 3\0", 16);
    std::ifstream stream(file, std::ios::binary);
    std::string head(magic.size(), '\0');
    return stream.read(head.data(), std::streamsize(head.size())) && head == magic;
}

// Escapes a path for a URI, as SQLite parses it.
std::string escaped(const std::string& path) {
    std::string text;
    for (const char letter : path)
        text += letter == '?' || letter == '#' || letter == '%'
                    ? fmt::format("%{:02X}", static_cast<unsigned char>(letter))
                    : std::string(1, letter);
    return text;
}

// Opens without a lock and leaves no file beside the database, unless another program is writing to it.
OpenFile openFile(const std::filesystem::path& file) {
    const std::string uri = fmt::format("file:{}{}", escaped(std::filesystem::absolute(file).string()),
                                        isBeingWritten(file) ? "" : "?immutable=1");
    sqlite3* database = nullptr;
    const int code = sqlite3_open_v2(uri.c_str(), &database, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
    OpenFile open(database);
    if (code != SQLITE_OK) return nullptr;
    sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    return open;
}

Query prepareQuery(const OpenFile& database, const char* sql) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(database.get(), sql, -1, &statement, nullptr);
    return Query(statement);
}

std::string firstText(const Query& query) {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(query.get(), 0));
    return text != nullptr ? text : "";
}

// The standard's own tables are checked first: the list of layers is read from them only if they are tables.
// Views and virtual tables have no root page; hidden columns of the kinds 2 and 3 are computed from others.
constexpr const char* standardTables =
    "SELECT name FROM sqlite_master WHERE type IN ('table', 'view') "
    "AND (ifnull(rootpage, 0) = 0 OR sql LIKE 'create virtual%') "
    "AND (name LIKE 'gpkg%' OR name LIKE 'sqlite%' OR name LIKE 'ogr%')";
constexpr const char* projectTable =
    "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = 'noonmark' COLLATE NOCASE";
constexpr const char* listedTables =
    "SELECT name FROM sqlite_master WHERE type IN ('table', 'view') "
    "AND (ifnull(rootpage, 0) = 0 OR sql LIKE 'create virtual%') "
    "AND name COLLATE NOCASE IN (SELECT table_name FROM gpkg_contents)";
constexpr const char* computedColumns =
    "SELECT master.name FROM sqlite_master AS master, pragma_table_xinfo(master.name) AS field "
    "WHERE master.type = 'table' AND master.rootpage > 0 AND master.sql NOT LIKE 'create virtual%' "
    "AND field.hidden IN (2, 3)";
constexpr const char* tooManyLayers =
    "SELECT count(*) || ' layers' FROM gpkg_contents HAVING count(*) > 1000";  // mostLayers

// What must find nothing, in this order, and what it means if it does.
struct Check {
    const char* query;
    const char* trouble;
    const char* advice;
};
constexpr const char* viewTrouble =
    "A layer of the GeoPackage is a view or a virtual table, whose SQL is not run";
constexpr std::array checks{
    Check{standardTables, viewTrouble, "Export the layer into a new GeoPackage"},
    Check{listedTables, viewTrouble, "Export the layer into a new GeoPackage"},
    Check{tooManyLayers, "The GeoPackage has more than 1,000 layers", "Export the layers of buildings alone"},
    Check{computedColumns, "A table of the GeoPackage computes a column, whose SQL is not run",
          "Export the layer into a new GeoPackage"}};
static_assert(mostLayers == 1000);

int isStopRequested(void*) { return StopScope::isStopped() ? 1 : 0; }

}  // namespace

bool isBeingWritten(const std::filesystem::path& database) {
    for (const char* ending : {"-wal", "-journal"}) {
        std::error_code error;
        const auto bytes = std::filesystem::file_size(database.string() + ending, error);
        if (!error && bytes > 0) return true;
    }
    return false;
}

Result<bool> holdsProject(const std::filesystem::path& file) {
    if (!isDatabase(file)) return false;
    const OpenFile database = openFile(file);
    const Query query = database ? prepareQuery(database, projectTable) : Query();
    const int step = query ? sqlite3_step(query.get()) : SQLITE_CANTOPEN;
    if (step == SQLITE_ROW || step == SQLITE_DONE) return step == SQLITE_ROW;
    return failure(fmt::format("Whether this is a Noonmark project could not be determined ({})",
                               database ? sqlite3_errmsg(database.get()) : "the database cannot be opened"),
                   file.string(), "Close it in other programs, or name another file");
}

Result<void> checkGeoPackage(const std::filesystem::path& file) {
    const OpenFile database = openFile(file);
    if (!database) return failure("The GeoPackage cannot be opened", file.string(), "Export it again");
    for (const Check& check : checks) {
        const Query query = prepareQuery(database, check.query);
        const int step = query ? sqlite3_step(query.get()) : SQLITE_ERROR;
        if (step == SQLITE_ROW)
            return failure(check.trouble, fmt::format("{}, '{}'", file.string(), firstText(query)),
                           check.advice);
        if (step != SQLITE_DONE)
            return failure(fmt::format("The GeoPackage is damaged ({})", sqlite3_errmsg(database.get())),
                           file.string(), "Export it again");
    }
    return {};
}

void limitGeoPackage(void* database) {
    constexpr int mostBytes = 100'000'000;  // of a text or a geometry: a ring of 6 million points
    constexpr int instructions = 10'000;    // about 0.1 ms
    auto* const sqlite = static_cast<sqlite3*>(database);
    sqlite3_limit(sqlite, SQLITE_LIMIT_LENGTH, mostBytes);
    sqlite3_progress_handler(sqlite, instructions, isStopRequested, nullptr);
}

}  // namespace noonmark
