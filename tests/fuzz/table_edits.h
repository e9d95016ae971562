#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tests/fuzz/require.h"

namespace noonmark::tests {

/// A good SQLite file whose cells the input changes: bytes changed by chance would never get past SQLite's
/// own checks. Backend: table_edits_sqlite.cpp.
class TableEdits {
public:
    /// Takes the file into memory.
    explicit TableEdits(const std::filesystem::path& file);

    /// Writes the file anew under `name` in fuzzFolder(), changed by the input: a list of edits of a byte
    /// each for
    ///   the cell's column (two bytes: which of all columns of all tables), its row and the kind of edit,
    ///   the number of bytes that follow, and those bytes.
    /// Kinds: null, integer, real, text, blob; bytes put into the old value in place of some of its own (the
    /// value keeps its type); the row is removed; the row is there twice. Edits that SQLite refuses, as its
    /// constraints do, are left out.
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
