#include "core/io/files/geopackage_check.h"

#include <fmt/format.h>
#include <sqlite3.h>
#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>

#include "core/base/stop_scope.h"

namespace noonmark {

namespace {

namespace fs = std::filesystem;

// SQLite file format, section 3. The magic number begins each header of a rollback journal; where a journal
// names a super-journal, the number also ends the file, after the name, its length and a checksum.
constexpr std::string_view journalMagic("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8);

std::uint32_t numberAt(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

// As many bytes of the file as it has; fewer at its end.
std::string bytesAt(std::ifstream& stream, std::uintmax_t at, std::size_t count) {
    std::string bytes(count, '\0');
    stream.clear();
    stream.seekg(std::streamoff(at));
    stream.read(bytes.data(), std::streamsize(count));
    bytes.resize(std::size_t(stream.gcount()));
    return bytes;
}

Result<void> checkEnd(std::ifstream& stream, const fs::path& journal, std::uintmax_t size) {
    constexpr std::size_t endBytes = 16;
    if (size < endBytes) return {};
    const std::string end = bytesAt(stream, size - endBytes, endBytes);
    if (end.size() < endBytes || end.substr(8) != journalMagic || numberAt(end, 0) == 0) return {};
    return failure("The journal beside the file names another file, which opening it would delete",
                   journal.string(),
                   "Do not trust the file. Remove the journal to see the file without it, or ask for a file "
                   "that was closed");
}

Result<void> checkBegin(std::ifstream& stream, const fs::path& journal, std::uintmax_t bothBytes) {
    constexpr std::size_t headBytes = 28;
    const std::string head = bytesAt(stream, 0, headBytes);
    if (head.size() < headBytes || !head.starts_with(journalMagic)) return {};
    const std::uintmax_t pages = numberAt(head, 16), pageBytes = std::max(numberAt(head, 24), 512U);
    if (pages * pageBytes <= bothBytes) return {};
    return failure("The journal beside the file states a size that the file never had", journal.string(),
                   "Remove the journal to see the file without it, or ask for a file that was closed");
}

Result<void> checkJournal(const fs::path& database) {
    const fs::path journal = database.string() + "-journal";
    std::error_code error;
    const std::uintmax_t size = fs::file_size(journal, error);
    if (error || size == 0) return {};
    const std::uintmax_t databaseBytes = fs::file_size(database, error);
    std::ifstream stream(journal, std::ios::binary);
    if (auto end = checkEnd(stream, journal, size); !end) return end;
    return checkBegin(stream, journal, size + (error ? 0 : databaseBytes));
}

}  // namespace

Result<void> checkBeside(const fs::path& given) {
    std::error_code error;
    fs::path database = fs::weakly_canonical(given, error);  // SQLite looks beside what a link names
    if (error) database = given;
    for (const char* ending : {"-journal", "-wal", "-shm"}) {
        const fs::path beside = database.string() + ending;
        const fs::file_status status = fs::symlink_status(beside, error);
        if (fs::exists(status) && !fs::is_regular_file(status))
            return failure("A file beside it is a link, a pipe or a device", beside.string(), "Remove it");
    }
    return checkJournal(database);
}

int longestValue(const fs::path& database) {
    std::uintmax_t bytes = 0;
    for (const char* ending : {"", "-wal"}) {
        std::error_code error;
        const std::uintmax_t size = fs::file_size(database.string() + ending, error);
        if (!error) bytes += size;
    }
    return int(std::clamp<std::uintmax_t>(bytes, 1'000'000, 1'000'000'000));
}

// SQLite's own access to files, with a look at each name before. SQLite calls the functions through its
// table, in which `vfs.pAppData` leads back to this object; they let no exception out.
struct OwnFiles::Access {
    std::string name = fmt::format("noonmark-{}", fmt::ptr(this));
    sqlite3_vfs* system = sqlite3_vfs_find(nullptr);
    sqlite3_vfs vfs = *system;
    std::string database;  // full path, from the moment it is opened

    Access() {
        vfs.pNext = nullptr;
        vfs.zName = name.c_str();
        vfs.pAppData = this;
        vfs.xOpen = open;
        vfs.xDelete = remove;
        vfs.xAccess = look;
        vfs.xFullPathname = fullName;
        sqlite3_vfs_register(&vfs, 0);
    }
    ~Access() { sqlite3_vfs_unregister(&vfs); }
    Access(const Access&) = delete;
    Access& operator=(const Access&) = delete;

    static Access& of(sqlite3_vfs* table) { return *static_cast<Access*>(table->pAppData); }

    [[nodiscard]] bool isJournal(std::string_view path) const {
        if (database.empty() || !path.starts_with(database)) return false;
        const std::string_view ending = path.substr(database.size());
        return ending == "-journal" || ending == "-wal";
    }
    [[nodiscard]] bool isOwn(std::string_view path) const { return path == database || isJournal(path); }

    // A temporary file has no name.
    static int open(sqlite3_vfs* table, const char* path, sqlite3_file* file, int flags,
                    int* given) noexcept {
        Access& access = of(table);
        file->pMethods = nullptr;
        const bool isFirst = (flags & SQLITE_OPEN_MAIN_DB) != 0 && access.database.empty();
        if (path != nullptr && isFirst) access.database = path;
        if (path != nullptr && !access.isOwn(path)) return SQLITE_CANTOPEN;
        return access.system->xOpen(access.system, path, file, flags, given);
    }
    static int remove(sqlite3_vfs* table, const char* path, int sync) noexcept {
        Access& access = of(table);
        if (!access.isJournal(path)) return SQLITE_IOERR_DELETE;
        return access.system->xDelete(access.system, path, sync);
    }
    static int look(sqlite3_vfs* table, const char* path, int flags, int* found) noexcept {
        Access& access = of(table);
        if (!access.isOwn(path)) return SQLITE_IOERR_ACCESS;
        return access.system->xAccess(access.system, path, flags, found);
    }
    static int fullName(sqlite3_vfs* table, const char* path, int bytes, char* full) noexcept {
        Access& access = of(table);
        return access.system->xFullPathname(access.system, path, bytes, full);
    }
};

OwnFiles::OwnFiles() : access_(std::make_unique<Access>()) {}
OwnFiles::~OwnFiles() = default;

const char* OwnFiles::name() const { return access_->name.c_str(); }

namespace {

struct CloseDatabase {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
};
struct EndStatement {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
/// Closed before the files it may reach are forgotten.
struct OpenDatabase {
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
Result<OpenDatabase> openDatabase(const std::filesystem::path& file) {
    if (auto harmless = checkBeside(file); !harmless) return tl::make_unexpected(harmless.error());
    const std::string uri = fmt::format("file:{}{}", escaped(std::filesystem::absolute(file).string()),
                                        isBeingWritten(file) ? "" : "?immutable=1");
    OpenDatabase open;
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

Query prepareQuery(const OpenDatabase& open, const std::string& sql) {
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

Error unreadable(const OpenDatabase& open, const std::filesystem::path& file) {
    // Only a connection that writes can undo what a stopped program left in a journal.
    if ((sqlite3_errcode(open.database.get()) & 0xff) == SQLITE_READONLY)
        return {"Another program was stopped while it wrote the GeoPackage, and left a journal beside it",
                file.string(), "Open and close it in that program, or export it again"};
    return {fmt::format("The GeoPackage is damaged ({})", sqlite3_errmsg(open.database.get())), file.string(),
            "Export it again"};
}

bool holdsTable(const OpenDatabase& open, const char* name) {
    const Query query =
        prepareQuery(open, fmt::format("SELECT 1 FROM sqlite_master WHERE name = '{}' COLLATE NOCASE", name));
    return query && sqlite3_step(query.get()) == SQLITE_ROW;
}

Result<void> checkFor(const Forbidden& one, const OpenDatabase& open, const std::filesystem::path& file) {
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
    const auto open = openDatabase(file);
    if (!open) return tl::make_unexpected(open.error());
    const Query query = prepareQuery(*open, projectTable);
    const int step = query ? sqlite3_step(query.get()) : SQLITE_CANTOPEN;
    if (step == SQLITE_ROW || step == SQLITE_DONE) return step == SQLITE_ROW;
    return failure(fmt::format("Whether this is a Noonmark project could not be determined ({})",
                               sqlite3_errmsg(open->database.get())),
                   file.string(), "Close it in other programs, or name another file");
}

Result<void> checkGeoPackage(const std::filesystem::path& file) {
    const auto open = openDatabase(file);
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
