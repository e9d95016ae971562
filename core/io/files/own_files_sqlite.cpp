#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

#include "core/io/files/own_files.h"

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

}  // namespace noonmark
