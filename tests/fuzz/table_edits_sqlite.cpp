#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/table_edits.h"

namespace noonmark::tests {

namespace {

using Bytes = std::span<const std::uint8_t>;

struct Close {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using OpenFile = std::unique_ptr<sqlite3, Close>;
using Query = std::unique_ptr<sqlite3_stmt, Close>;

OpenFile opened(const std::filesystem::path& file) {
    sqlite3* database = nullptr;
    sqlite3_open(file.c_str(), &database);
    OpenFile open(database);
    sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_exec(database, "PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; BEGIN", nullptr, nullptr,
                 nullptr);
    return open;
}

Query prepared(const OpenFile& database, const std::string& sql) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(database.get(), sql.c_str(), -1, &statement, nullptr);
    return Query(statement);
}

void run(const OpenFile& database, const std::string& sql) {
    sqlite3_exec(database.get(), sql.c_str(), nullptr, nullptr, nullptr);
}

std::string_view textIn(const Query& query, int column) {
    return reinterpret_cast<const char*>(sqlite3_column_text(query.get(), column));
}

enum class Kind { null, integer, real, text, blob, splice, removeRow, copyRow };

struct Edit {
    std::size_t column = 0;  // index over all columns, modulo their number
    int row = 0;             // modulo their number
    Kind kind = Kind::null;
    Bytes bytes;
};

/// Reads edits from the input until it ends.
class EditList {
public:
    explicit EditList(Bytes input) : rest_(input) {}

    std::optional<Edit> next() {
        constexpr std::size_t headBytes = 4;
        if (rest_.size() < headBytes) return std::nullopt;
        Edit edit{std::size_t(rest_[0]) + 256 * std::size_t(rest_[1]), rest_[2] / 8, Kind(rest_[2] % 8), {}};
        const std::size_t count = std::min<std::size_t>(rest_[3], rest_.size() - headBytes);
        edit.bytes = rest_.subspan(headBytes, count);
        rest_ = rest_.subspan(headBytes + count);
        return edit;
    }

private:
    Bytes rest_;
};

template <class T>
T numberIn(Bytes bytes) {
    T number{};
    std::memcpy(&number, bytes.data(), std::min(bytes.size(), sizeof number));
    return number;
}

// The first three bytes: position (two), and number of old bytes to replace.
std::string spliced(std::string_view old, Bytes bytes) {
    std::string value(old);
    if (bytes.size() < 3) return value;
    const std::size_t at = numberIn<std::uint16_t>(bytes) % (value.size() + 1);
    const std::string put(bytes.begin() + 3, bytes.end());
    return value.replace(at, std::min<std::size_t>(bytes[2], value.size() - at), put);
}

void bindBytes(sqlite3_stmt* to, bool asText, std::string_view value) {
    if (asText)
        sqlite3_bind_text64(to, 1, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
    else
        sqlite3_bind_blob64(to, 1, value.data(), value.size(), SQLITE_TRANSIENT);
}

// `old`: a row with the value and its type.
void bindValue(sqlite3_stmt* to, const Edit& edit, const Query& old) {
    const std::string_view bytes(reinterpret_cast<const char*>(edit.bytes.data()), edit.bytes.size());
    switch (edit.kind) {
        case Kind::integer:
            sqlite3_bind_int64(to, 1, numberIn<std::int64_t>(edit.bytes));
            break;
        case Kind::real:
            sqlite3_bind_double(to, 1, numberIn<double>(edit.bytes));
            break;
        case Kind::text:
        case Kind::blob:
            bindBytes(to, edit.kind == Kind::text, bytes);
            break;
        case Kind::splice: {
            const auto* value = static_cast<const char*>(sqlite3_column_blob(old.get(), 1));
            const std::size_t size = std::size_t(sqlite3_column_bytes(old.get(), 1));
            bindBytes(
                to, textIn(old, 2) != "blob",
                spliced(value == nullptr ? std::string_view() : std::string_view(value, size), edit.bytes));
            break;
        }
        default:
            break;  // unbound: null
    }
}

void apply(const OpenFile& database, const std::string& table, const std::string& column, const Edit& edit) {
    const Query old = prepared(
        database, fmt::format("SELECT rowid, CAST(\"{1}\" AS blob), typeof(\"{1}\") FROM \"{0}\" LIMIT 1 "
                              "OFFSET {2} % max(1, (SELECT count(*) FROM \"{0}\"))",
                              table, column, edit.row));
    if (!old || sqlite3_step(old.get()) != SQLITE_ROW) return;
    const std::int64_t row = sqlite3_column_int64(old.get(), 0);
    if (edit.kind == Kind::removeRow)
        return run(database, fmt::format("DELETE FROM \"{}\" WHERE rowid = {}", table, row));
    if (edit.kind == Kind::copyRow)
        return run(database,
                   fmt::format("INSERT INTO \"{0}\" SELECT * FROM \"{0}\" WHERE rowid = {1}", table, row));
    const Query change = prepared(
        database, fmt::format("UPDATE OR IGNORE \"{}\" SET \"{}\" = ? WHERE rowid = {}", table, column, row));
    if (!change) return;
    bindValue(change.get(), edit, old);
    sqlite3_step(change.get());
}

}  // namespace

TableEdits::TableEdits(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    whole_.assign(std::istreambuf_iterator<char>(stream), {});
    const OpenFile database = opened(file);
    const Query columns =
        prepared(database,
                 "SELECT t.name, c.name FROM sqlite_master t, pragma_table_info(t.name) c "
                 "WHERE t.type = 'table' AND t.name NOT LIKE 'sqlite%' AND t.name NOT LIKE 'rtree%'");
    while (sqlite3_step(columns.get()) == SQLITE_ROW)
        columns_.push_back({std::string(textIn(columns, 0)), std::string(textIn(columns, 1))});
    require(!columns_.empty(), "the file to be edited has tables");
}

std::filesystem::path TableEdits::edited(const std::string& name, Bytes input) const {
    std::filesystem::path file = fuzzFile(name, whole_);
    const OpenFile database = opened(file);
    EditList edits(input);
    while (const auto edit = edits.next()) {
        const Column& column = columns_[edit->column % columns_.size()];
        apply(database, column.table, column.name, *edit);
    }
    run(database, "COMMIT");
    return file;
}

}  // namespace noonmark::tests
