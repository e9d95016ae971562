#include <fmt/format.h>
#include <sqlite3.h>

#include <fstream>
#include <memory>
#include <string>
#include <string_view>

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
// Views and virtual tables have no root page.
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
    for (const char* tables : {standardTables, listedTables}) {
        const Query query = prepareQuery(database, tables);
        if (!query)
            return failure(fmt::format("The GeoPackage is damaged ({})", sqlite3_errmsg(database.get())),
                           file.string(), "Export it again");
        const int step = sqlite3_step(query.get());
        if (step == SQLITE_ROW)
            return failure("A layer of the GeoPackage is a view or a virtual table, whose SQL is not run",
                           fmt::format("{}, '{}'", file.string(), firstText(query)),
                           "Export the layer into a new GeoPackage");
        if (step != SQLITE_DONE)
            return failure(fmt::format("The GeoPackage is damaged ({})", sqlite3_errmsg(database.get())),
                           file.string(), "Export it again");
    }
    return {};
}

}  // namespace noonmark
