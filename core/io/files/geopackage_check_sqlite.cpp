#include <fmt/format.h>
#include <sqlite3.h>

#include <array>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/stop_scope.h"
#include "core/io/files/geopackage_check.h"
#include "core/io/files/own_files.h"

namespace noonmark {

namespace {

struct CloseDatabase {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
};
struct EndStatement {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
/// Closed before the files it may reach are forgotten.
struct OpenFile {
    std::unique_ptr<OwnFiles> files = std::make_unique<OwnFiles>();
    std::unique_ptr<sqlite3, CloseDatabase> database;
};
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
Result<OpenFile> openFile(const std::filesystem::path& file) {
    if (auto harmless = checkBeside(file); !harmless) return tl::make_unexpected(harmless.error());
    const std::string uri = fmt::format("file:{}{}", escaped(std::filesystem::absolute(file).string()),
                                        isBeingWritten(file) ? "" : "?immutable=1");
    OpenFile open;
    sqlite3* database = nullptr;
    const int code =
        sqlite3_open_v2(uri.c_str(), &database, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, open.files->name());
    open.database.reset(database);
    if (code != SQLITE_OK)
        return failure("The database cannot be opened", file.string(),
                       "Close it in other programs, or export it again");
    sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_limit(database, SQLITE_LIMIT_LENGTH, longestValue(file));
    return open;
}

Query prepareQuery(const OpenFile& open, const std::string& sql) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(open.database.get(), sql.c_str(), -1, &statement, nullptr);
    return Query(statement);
}

std::string firstText(const Query& query) {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(query.get(), 0));
    return text != nullptr ? text : "";
}

constexpr const char* projectTable =
    "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = 'noonmark' COLLATE NOCASE";

/// What a GeoPackage may not hold, since reading it would run SQL of the file or fill the memory.
struct Forbidden {
    const char* sql;  ///< gives the name of each table that has it
    const char* what;
    const char* needs = nullptr;  ///< the table that the SQL reads; without it there is nothing to find
    const char* advice = "Export the layer into a new GeoPackage";
};

// The standard's own tables are checked first: the list of layers is read from them only if they are tables.
// SQLite itself tells what is a view or a virtual table, however its SQL is written. Spatial indexes are
// virtual tables of a kind that SQLite itself brings; a view of that name is none.
constexpr const char* runsSql =
    "A layer of the GeoPackage is a view or a virtual table, whose SQL is not run";
constexpr std::array forbidden{
    Forbidden{"SELECT name FROM pragma_table_list WHERE schema = 'main' AND type IN ('view', 'virtual') "
              "AND (name LIKE 'gpkg%' OR name LIKE 'sqlite%' OR name LIKE 'ogr%')",
              runsSql},
    Forbidden{
        "SELECT name FROM sqlite_master WHERE name LIKE 'rtree%' AND (type = 'view' OR "
        "(sql LIKE 'create virtual%' AND substr(sql, instr(lower(sql), 'using')) NOT LIKE 'using rtree%'))",
        runsSql},
    Forbidden{"SELECT name FROM pragma_table_list WHERE schema = 'main' AND type IN ('view', 'virtual') "
              "AND name COLLATE NOCASE IN (SELECT table_name FROM gpkg_contents)",
              runsSql},
    Forbidden{"SELECT count(*) || ' layers' FROM gpkg_contents HAVING count(*) > 1000",  // maxLayers
              "The GeoPackage has more than 1,000 layers", "gpkg_contents",
              "Export the layers of buildings alone"},
    Forbidden{"SELECT t.name || '.' || c.name FROM pragma_table_list t, pragma_table_xinfo(t.name) c "
              "WHERE t.schema = 'main' AND t.type = 'table' AND c.hidden IN (2, 3)",
              "A column of the GeoPackage is computed by SQL of the file, which is not run"},
    // GDAL takes 16 bytes for each pixel of a tile.
    Forbidden{"SELECT table_name FROM gpkg_tile_matrix WHERE NOT ifnull(tile_width BETWEEN 1 AND 4096 "
              "AND tile_height BETWEEN 1 AND 4096, 0)",
              "The tiles of a layer are larger than 4,096 x 4,096, or have no size", "gpkg_tile_matrix"},
};
static_assert(maxLayers == 1000);

Error unreadable(const OpenFile& open, const std::filesystem::path& file) {
    // Only a connection that writes can undo what a stopped program left in a journal.
    if ((sqlite3_errcode(open.database.get()) & 0xff) == SQLITE_READONLY)
        return {"Another program was stopped while it wrote the GeoPackage, and left a journal beside it",
                file.string(), "Open and close it in that program, or export it again"};
    return {fmt::format("The GeoPackage is damaged ({})", sqlite3_errmsg(open.database.get())), file.string(),
            "Export it again"};
}

bool holdsTable(const OpenFile& open, const char* name) {
    const Query query =
        prepareQuery(open, fmt::format("SELECT 1 FROM sqlite_master WHERE name = '{}' COLLATE NOCASE", name));
    return query && sqlite3_step(query.get()) == SQLITE_ROW;
}

Result<void> checkFor(const Forbidden& one, const OpenFile& open, const std::filesystem::path& file) {
    if (one.needs != nullptr && !holdsTable(open, one.needs)) return {};
    const Query query = prepareQuery(open, one.sql);
    const int step = query ? sqlite3_step(query.get()) : SQLITE_ERROR;
    if (step == SQLITE_ROW)
        return failure(one.what, fmt::format("{}, '{}'", file.string(), firstText(query)), one.advice);
    if (step != SQLITE_DONE) return tl::make_unexpected(unreadable(open, file));
    return {};
}

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
    const auto open = openFile(file);
    if (!open) return tl::make_unexpected(open.error());
    const Query query = prepareQuery(*open, projectTable);
    const int step = query ? sqlite3_step(query.get()) : SQLITE_CANTOPEN;
    if (step == SQLITE_ROW || step == SQLITE_DONE) return step == SQLITE_ROW;
    return failure(fmt::format("Whether this is a Noonmark project could not be determined ({})",
                               sqlite3_errmsg(open->database.get())),
                   file.string(), "Close it in other programs, or name another file");
}

Result<void> checkGeoPackage(const std::filesystem::path& file) {
    const auto open = openFile(file);
    if (!open) return tl::make_unexpected(open.error());
    for (const Forbidden& one : forbidden)
        if (auto free = checkFor(one, *open, file); !free) return free;
    return {};
}

void limitGeoPackage(void* database) {
    constexpr int maxBytes = 100'000'000;  // of a text or a geometry: a ring of 6 million points
    constexpr int instructions = 10'000;   // about 0.1 ms
    auto* const sqlite = static_cast<sqlite3*>(database);
    sqlite3_limit(sqlite, SQLITE_LIMIT_LENGTH, maxBytes);
    sqlite3_progress_handler(sqlite, instructions, isStopRequested, nullptr);
}

}  // namespace noonmark
