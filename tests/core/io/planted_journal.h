#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace noonmark::tests {

inline std::string allBytes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    return bytes.str();
}

inline std::string bigEndian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += char(value >> unsigned(shift) & 0xffU);
    return bytes;
}

/// The end of a journal of a transaction over several databases: the name of its super-journal.
inline std::string superJournal(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::uint32_t sum = 0;
    for (const char letter : name) sum += std::uint32_t(int(letter));
    return bigEndian(0x40000000 / 4096 + 1) + name + bigEndian(std::uint32_t(name.size())) + bigEndian(sum) +
           std::string("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8);
}

/// Leaves beside an SQLite file the journal of a transaction that was not finished: the next program that
/// writes to it rolls back. If it `names` a file, SQLite then deletes that file.
inline void plantJournal(const std::filesystem::path& database, const std::filesystem::path& names = {}) {
    const std::string work = database.string() + ".work";
    std::filesystem::copy_file(database, work);
    sqlite3* live = nullptr;
    sqlite3_open(work.c_str(), &live);
    const char* begin = "PRAGMA synchronous = OFF; BEGIN IMMEDIATE; CREATE TABLE planted (x)";
    EXPECT_EQ(sqlite3_exec(live, begin, nullptr, nullptr, nullptr), SQLITE_OK);
    const std::string journal = allBytes(work + "-journal");
    EXPECT_GT(journal.size(), 4096U);
    sqlite3_close(live);
    for (const char* ending : {"", "-journal"}) std::filesystem::remove(work + ending);
    std::ofstream(database.string() + "-journal", std::ios::binary)
        << journal << (names.empty() ? std::string() : superJournal(names));
}

}  // namespace noonmark::tests
