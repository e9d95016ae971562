#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tests/fuzz/require.h"

namespace noonmark::tests {

/// A valid SQLite file whose cells the input changes: random changes of bytes would never pass SQLite's own
/// checks. Backend: table_edits_sqlite.cpp.
class TableEdits {
public:
    /// Reads the file into memory.
    explicit TableEdits(const std::filesystem::path& file);

    /// Writes the file under `name` in fuzzFolder() with the changes given by the input, a list of edits.
    /// Each edit has one byte each for
    ///   the cell's column (two bytes: an index over all columns of all tables), its row and the kind of
    ///   edit, the number of bytes that follow, and those bytes.
    /// Kinds: null, integer, real, text, blob; bytes inserted into the old value in place of some of its own
    /// (the value keeps its type); the row is removed; the row is duplicated. Edits that SQLite refuses, for
    /// example because of its constraints, are skipped.
    [[nodiscard]] std::filesystem::path edited(const std::string& name,
                                               std::span<const std::uint8_t> input) const;

private:
    struct Column {
        std::string table, name;
    };

    std::string whole_;
    std::vector<Column> columns_;
};

}  // namespace noonmark::tests
