#include <fmt/format.h>
#include <sqlite3.h>

#include <utility>

#include "core/io/files/geopackage_check.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

namespace {

constexpr int waitMs = 500;

[[noreturn]] void fail(sqlite3* database, int code) {
    throw DatabaseError{code & 0xff, database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code)};
}

void check(sqlite3_stmt* statement, int code) {
    if (code != SQLITE_OK) fail(sqlite3_db_handle(statement), code);
}

int flagsOf(Database::Access access) {
    switch (access) {
        case Database::Access::read:
            return SQLITE_OPEN_READONLY;
        case Database::Access::write:
            return SQLITE_OPEN_READWRITE;
        case Database::Access::create:
            return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    }
    return SQLITE_OPEN_READONLY;
}

// Reading a city of a million buildings takes 100 million steps of SQLite's virtual machine.
constexpr int stepsBetweenLooks = 1'000'000;
constexpr int maxLooks = 5000;  // about a minute

int isTooLong(void* looks) { return ++*static_cast<int*>(looks) > maxLooks ? 1 : 0; }

void harden(sqlite3* database) {
    const auto set = [&](int option, int value) { sqlite3_db_config(database, option, value, nullptr); };
    set(SQLITE_DBCONFIG_DEFENSIVE, 1);
    set(SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0);
    set(SQLITE_DBCONFIG_ENABLE_TRIGGER, 0);
    set(SQLITE_DBCONFIG_ENABLE_VIEW, 0);
    set(SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0);
    set(SQLITE_DBCONFIG_DQS_DML, 0);      // a quoted name that is no column is an error, not a text
    set(SQLITE_DBCONFIG_ENABLE_FKEY, 0);  // a foreign key could delete other rows
    sqlite3_limit(database, SQLITE_LIMIT_ATTACHED, 0);
    sqlite3_limit(database, SQLITE_LIMIT_TRIGGER_DEPTH, 1);
    sqlite3_limit(database, SQLITE_LIMIT_WORKER_THREADS, 0);
    sqlite3_limit(database, SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 100);
}

}  // namespace

Statement::Statement(sqlite3* database, std::string_view sql) {
    const int code = sqlite3_prepare_v2(database, sql.data(), int(sql.size()), &statement_, nullptr);
    if (code != SQLITE_OK) fail(database, code);
}

Statement::Statement(Statement&& other) noexcept : statement_(std::exchange(other.statement_, nullptr)) {}
Statement::~Statement() { sqlite3_finalize(statement_); }

void Statement::reset() { sqlite3_reset(statement_); }

bool Statement::step() {
    const int code = sqlite3_step(statement_);
    if (code == SQLITE_ROW) return true;
    if (code == SQLITE_DONE) return false;
    fail(sqlite3_db_handle(statement_), code);
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_, column); }
double Statement::real(int column) const { return sqlite3_column_double(statement_, column); }
bool Statement::isNumber(int column) const {
    const int type = sqlite3_column_type(statement_, column);
    return type == SQLITE_INTEGER || type == SQLITE_FLOAT;
}
bool Statement::isNull(int column) const { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }

std::string Statement::text(int column) const {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
    return text == nullptr ? std::string()
                           : std::string(text, std::size_t(sqlite3_column_bytes(statement_, column)));
}

std::string_view Statement::blob(int column) const {
    const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_, column));
    return bytes == nullptr ? std::string_view()
                            : std::string_view(bytes, std::size_t(sqlite3_column_bytes(statement_, column)));
}

void Statement::bind(int at, std::int64_t value) {
    check(statement_, sqlite3_bind_int64(statement_, at, value));
}
void Statement::bind(int at, double value) { check(statement_, sqlite3_bind_double(statement_, at, value)); }
void Statement::bindNull(int at) { check(statement_, sqlite3_bind_null(statement_, at)); }

void Statement::bind(int at, std::string_view text) {
    check(statement_,
          sqlite3_bind_text64(statement_, at, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
}

void Statement::bind(int at, const AsBlob& blob) {
    check(statement_,
          sqlite3_bind_blob64(statement_, at, blob.bytes.data(), blob.bytes.size(), SQLITE_STATIC));
}

namespace {

constexpr const char* inMemory = ":memory:";

// An absolute path cannot be mistaken for a URI, which could name another way to files.
std::filesystem::path pathOf(const std::filesystem::path& file) {
    return file == inMemory ? file : std::filesystem::absolute(file);
}

}  // namespace

Database::Database(const std::filesystem::path& file, Access access) : files_(std::make_unique<OwnFiles>()) {
    const int code = sqlite3_open_v2(pathOf(file).c_str(), &database_, flagsOf(access), files_->name());
    if (code != SQLITE_OK) {
        DatabaseError error{code & 0xff, sqlite3_errmsg(database_)};
        sqlite3_close(database_);
        throw error;
    }
    harden(database_);
    sqlite3_progress_handler(database_, stepsBetweenLooks, isTooLong, &looks_);
    sqlite3_busy_timeout(database_, waitMs);
}

Database::Database(InMemory, Database& source) : Database(inMemory, Access::create) {
    sqlite3_backup* copy = sqlite3_backup_init(database_, "main", source.database_, "main");
    if (copy == nullptr) fail(database_, sqlite3_errcode(database_));
    sqlite3_backup_step(copy, -1);
    if (const int code = sqlite3_backup_finish(copy); code != SQLITE_OK) fail(database_, code);
    sqlite3_limit(database_, SQLITE_LIMIT_LENGTH, sqlite3_limit(source.database_, SQLITE_LIMIT_LENGTH, -1));
}

Database::~Database() { sqlite3_close(database_); }

void Database::limitValues(const std::filesystem::path& file) {
    sqlite3_limit(database_, SQLITE_LIMIT_LENGTH, longestValue(file));
}

void Database::execute(const std::string& sql) {
    const int code = sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) fail(database_, code);
}

std::optional<std::string> Database::value(std::string_view sql) {
    Statement statement = prepare(sql);
    if (!statement.step()) return std::nullopt;
    return statement.text(0);
}

std::int64_t Database::lastRow() const { return sqlite3_last_insert_rowid(database_); }
std::int64_t Database::changedRows() const { return sqlite3_total_changes(database_); }

Transaction::Transaction(Database& database, bool toWrite) : database_(database) {
    database.execute(toWrite ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
    if (!open_) return;
    try {
        database_.execute("ROLLBACK");
    } catch (const DatabaseError&) {
        // SQLite also rolls back when the connection is closed.
    }
}

void Transaction::commit() {
    database_.execute("COMMIT");
    open_ = false;
}

void throwDamaged(const std::string& words) { throw DatabaseError{SQLITE_CORRUPT, words}; }

Error errorOf(const DatabaseError& error, const std::filesystem::path& file) {
    const std::string where = file.string();
    switch (error.code) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return {"Another program is writing the project", where, "Close it there, then try again"};
        case SQLITE_READONLY:
        case SQLITE_PERM:
            return {"The project file is read-only", where, "Save it under another name"};
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
        case SQLITE_FORMAT:
            return {fmt::format("The project file is damaged ({})", error.words), where,
                    "Take a copy of it, or the recovery file beside it; this file was not changed"};
        case SQLITE_CANTOPEN:
            return {"The project file cannot be opened", where,
                    "Check that it exists and that its folder is writable"};
        case SQLITE_TOOBIG:
            return {
                "The project file holds a value that is larger than the file: this program did not write it",
                where, "Ask for the file again, or take an older copy"};
        case SQLITE_CONSTRAINT:
            return {fmt::format("The project file has rows that contradict each other ({})", error.words),
                    where, "Save it under another name; the file was not changed"};
        case SQLITE_INTERRUPT:
            return {"Reading the project file takes too long: this program did not write it", where,
                    "Ask for the file again, or take an older copy"};
        case SQLITE_FULL:
            return {"The disk is full", where,
                    "Free some space, or save elsewhere; the file was not changed"};
        default:
            return {fmt::format("The project file cannot be used ({})", error.words), where,
                    "Check that the disk is available and has free space"};
    }
}

}  // namespace noonmark
