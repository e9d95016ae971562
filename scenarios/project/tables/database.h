#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace noonmark {

using Bytes = std::string;  ///< of a blob

/// SQLite's own refusal, thrown inside scenarios/project only: `guarded` turns it into an Error.
struct DatabaseTrouble {
    int code = 0;       ///< SQLite's primary result code
    std::string words;  ///< SQLite's
};

/// A prepared statement. Columns count from 0, parameters are bound in order. Throws DatabaseTrouble.
class Statement {
public:
    Statement(sqlite3* database, std::string_view sql);
    Statement(Statement&&) noexcept;
    ~Statement();

    /// Binds all parameters and runs to the end; for what gives no rows.
    template <class... Values>
    void run(const Values&... values) {
        reset();
        int at = 0;
        (bind(++at, values), ...);
        while (step()) {
        }
    }

    /// Binds all parameters; then step() from row to row.
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
    [[nodiscard]] bool isNumber(int column) const;  ///< an integer or a real; NaN is stored as null

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

/// Marks bytes as a blob; they outlive the statement's run.
struct AsBlob {
    const Bytes& bytes;
};

/// An SQLite file that anybody may have made: no trigger of it runs and no view of it is read, it may not
/// name functions with effects, attach or load anything, and a statement that does not end is broken off. Not
/// for two threads at once. Backend: database_sqlite.cpp.
class Database {
public:
    enum class Access { read, write, create };

    /// Throws DatabaseTrouble. Whoever else writes is waited for, half a second at most.
    Database(const std::filesystem::path& file, Access access);
    /// A copy of another, in memory: what is done to it touches no file.
    struct InMemory {};
    Database(InMemory, Database& source);
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;
    ~Database();

    void execute(const std::string& sql);  ///< one or several statements without results
    [[nodiscard]] Statement prepare(std::string_view sql) { return {database_, sql}; }
    /// The first column of the first row; nothing without rows.
    [[nodiscard]] std::optional<std::string> value(std::string_view sql);
    [[nodiscard]] std::int64_t lastRow() const;
    [[nodiscard]] std::int64_t changedRows() const;  ///< in all since it was opened

private:
    sqlite3* database_ = nullptr;
    int looks_ = 0;  // how often the work of all statements was looked at
};

/// All or nothing: rolled back unless committed.
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

/// Throws what errorOf() calls a damaged file: contents that no program of ours wrote.
[[noreturn]] void throwDamaged(const std::string& words);

/// What SQLite's trouble means for a project file, in a planner's words.
Error errorOf(const DatabaseTrouble& trouble, const std::filesystem::path& file);

}  // namespace noonmark
