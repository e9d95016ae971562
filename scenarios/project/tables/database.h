#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/geo/grid.h"

// The folder scenarios/project/tables/ reads and writes the tables of a project file. This file wraps SQLite,
// schema.h creates, checks and migrates the tables, geopackage.h adds the tables of the GeoPackage standard,
// CheckedRow validates numbers; the other files handle one kind of content each: geometry, grid tiles,
// layer styles, points, the city, and settings.
struct sqlite3;
struct sqlite3_stmt;

namespace noonmark {

class OwnFiles;

using Bytes = std::string;  ///< a blob

/// An error of SQLite. It is thrown only inside scenarios/project, where `guarded` turns it into an Error.
struct DatabaseError {
    int code = 0;       ///< SQLite's primary result code
    std::string words;  ///< SQLite's message
};

/// A prepared statement. Columns count from 0; parameters are bound in order. Throws DatabaseError.
class Statement {
public:
    Statement(sqlite3* database, std::string_view sql);
    Statement(Statement&&) noexcept;
    ~Statement();

    /// Binds all parameters and runs a statement that returns no rows.
    template <class... Values>
    void run(const Values&... values) {
        reset();
        int at = 0;
        (bind(++at, values), ...);
        while (step()) {
        }
    }

    /// Binds all parameters; step() then moves from row to row.
    template <class... Values>
    void begin(const Values&... values) {
        reset();
        int at = 0;
        (bind(++at, values), ...);
    }

    bool step();  ///< false after the last row

    [[nodiscard]] std::int64_t integer(int column) const;
    [[nodiscard]] double real(int column) const;
    [[nodiscard]] std::string text(int column) const;
    /// Valid until the next step().
    [[nodiscard]] std::string_view blob(int column) const;
    [[nodiscard]] bool isNull(int column) const;
    [[nodiscard]] bool isNumber(
        int column) const;  ///< an integer or a real; false for NaN, which is stored as null

private:
    void reset();
    void bind(int at, std::int64_t value);
    void bind(int at, int value) { bind(at, std::int64_t(value)); }
    void bind(int at, bool value) { bind(at, std::int64_t(value)); }
    void bind(int at, std::size_t value) { bind(at, std::int64_t(value)); }
    void bind(int at, double value);
    void bind(int at, float value) { bind(at, double(value)); }
    void bind(int at, std::string_view text);
    void bind(int at, const std::string& text) { bind(at, std::string_view(text)); }
    void bind(int at, const char* text) { bind(at, std::string_view(text)); }
    void bind(int at, const struct AsBlob& blob);
    template <class T>
    void bind(int at, const std::optional<T>& value) {
        value ? bind(at, *value) : bindNull(at);
    }
    void bindNull(int at);

    sqlite3_stmt* statement_ = nullptr;
};

/// Marks bytes as a blob; they must outlive the statement's run.
struct AsBlob {
    const Bytes& bytes;
};

/// An open SQLite file, which may be hostile: its triggers and views do not run, it cannot attach or load
/// anything or call functions with side effects, no file but its own journals is opened or deleted, and a
/// statement that runs too long is interrupted. Not safe for concurrent use. Backend: database_sqlite.cpp.
class Database {
public:
    enum class Access { read, write, create };

    /// Throws DatabaseError. Waits at most half a second for another writer. See checkBeside() before.
    Database(const std::filesystem::path& file, Access access);
    /// A copy of another database in memory; changes touch no file.
    struct InMemory {};
    Database(InMemory, Database& source);
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;
    ~Database();

    /// From now on a value longer than the file is an error: SQL of the file made it. For reading only.
    void limitValues(const std::filesystem::path& file);

    void execute(const std::string& sql);  ///< one or several statements that return no rows
    [[nodiscard]] Statement prepare(std::string_view sql) { return {database_, sql}; }
    /// First column of the first row; empty without rows.
    [[nodiscard]] std::optional<std::string> value(std::string_view sql);
    [[nodiscard]] std::int64_t lastRow() const;
    [[nodiscard]] std::int64_t changedRows() const;  ///< since the database was opened

private:
    std::unique_ptr<OwnFiles> files_;  // outlives the connection
    sqlite3* database_ = nullptr;
    int looks_ = 0;  // checks of the running time so far, over all statements
};

/// Rolls back unless committed.
class Transaction {
public:
    explicit Transaction(Database& database, bool toWrite = true);
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    ~Transaction();
    void commit();

private:
    Database& database_;
    bool open_ = true;
};

/// Throws the error that errorOf() reports as a damaged file: content that this program never writes.
[[noreturn]] void throwDamaged(const std::string& words);

/// Translates an SQLite error on a project file into an Error for the user.
Error errorOf(const DatabaseError& error, const std::filesystem::path& file);

/// Smallest and largest permitted value of a number in a project file, both inclusive.
struct NumberLimits {
    double low = 0;
    double high = 0;
};
inline constexpr NumberLimits dayMinutes{0, 24 * 60};  ///< since midnight; 24:00 included

/// Far beyond any project. Larger values could overflow sums and products in float32 and int.
inline constexpr NumberLimits placeLimitsM{-1e6, 1e6};      ///< local x and y
inline constexpr NumberLimits elevationLimitsM{-2e4, 2e4};  ///< local z, and heights above the ellipsoid
inline constexpr NumberLimits cellLimitsM{1e-3, 1e5};       ///< side of a grid's cell
inline constexpr NumberLimits sideLimits{1, 200000};        ///< columns and rows of a grid
inline constexpr std::size_t maxGridCells = 250'000'000;    ///< 1 GB of float32
inline constexpr NumberLimits layerLimits{-1e9, 1e9};       ///< values of a result

[[nodiscard]] bool isWithin(double value, const NumberLimits& limits);  ///< false for NaN

/// Reads the numbers of one row of a project file and checks each one, because project files are untrusted.
/// Throws DatabaseError with table, row and column.
class CheckedRow {
public:
    /// Valid only while the statement stays on this row. `idColumn` holds the row's id.
    CheckedRow(const Statement& row, const char* table, int idColumn = 0)
        : row_(row), table_(table), id_(row.integer(idColumn)) {}

    [[nodiscard]] double number(int column, const char* name, const NumberLimits& limits) const;
    [[nodiscard]] int integer(int column, const char* name, const NumberLimits& limits) const;
    /// Reads five columns starting at `column`: west_m, south_m, cell_m, columns, rows.
    [[nodiscard]] Grid grid(int column) const;
    [[noreturn]] void refuse(std::string_view what) const;

private:
    const Statement& row_;
    const char* table_;
    std::int64_t id_;
};

}  // namespace noonmark
