#include "scenarios/project/project_file.h"

#include <fmt/format.h>
#include <array>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string_view>

#include "core/base/process.h"
#include "core/base/result.h"
#include "core/base/version.h"
#include "core/io/files/geopackage_check.h"
#include "core/io/files/write_text.h"
#include "scenarios/project/read_project.h"
#include "scenarios/project/tables/grid_tiles.h"
#include "scenarios/project/tables/schema.h"
#include "scenarios/project/write_project.h"

namespace noonmark {

namespace {

/// Checks that a file exists, is readable, is an SQLite file, has the length that its header states, and that
/// what lies beside it is harmless (checkBeside). Reads only the first 100 bytes. The length is not checked
/// where a journal lies beside the file: SQLite recovers it.
Result<void> checkWhole(const std::filesystem::path& file);

/// Checks that the file is writable. A file without any write permission counts as read-only for root, too.
Result<void> checkWritable(const std::filesystem::path& file);

namespace fs = std::filesystem;
using Head = std::array<unsigned char, 100>;

tl::unexpected<Error> damaged(const fs::path& file, const std::string& how) {
    return failure(fmt::format("The project file is damaged ({})", how), file.string(),
                   "Take a copy of it, or the recovery file beside it; this file was not changed");
}

std::uint64_t number(const Head& head, std::size_t at, int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8U | head[at + std::size_t(i)];
    return value;
}

// SQLite file format, section 1.3: page size (offset 16), change counter (24), page count (28), and the
// change counter for which the page count is valid (92).
Result<void> checkLength(const Head& head, const fs::path& file, std::uintmax_t size) {
    const std::uint64_t stated = number(head, 16, 2);
    const std::uint64_t pageBytes = stated == 1 ? 65536 : stated;
    const bool counts = number(head, 24, 4) == number(head, 92, 4);
    if (!counts || size >= number(head, 28, 4) * pageBytes) return {};
    return damaged(file, "its end is missing");
}

Result<void> checkWhole(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error)) return failure("There is no such file", file.string(), "Check its name");
    if (!fs::is_regular_file(file, error))
        return failure("It is not a file", file.string(), "Give the path of a project file");
    if (auto harmless = checkBeside(file); !harmless) return harmless;
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return failure("The project file cannot be read", file.string(), "Check its permissions");
    Head head{};
    stream.read(reinterpret_cast<char*>(head.data()), head.size());
    constexpr std::string_view magic("SQLite format 3\0", 16);
    const std::string_view begin(reinterpret_cast<const char*>(head.data()), magic.size());
    if (stream.gcount() == 0) return damaged(file, "it is empty");
    if (begin != magic)
        return failure("It is not a Noonmark project", file.string(),
                       "Choose a file that ends in .noonmark.gpkg");
    if (stream.gcount() < std::streamsize(head.size())) return damaged(file, "its end is missing");
    if (fs::exists(file.string() + "-journal", error)) return {};
    return checkLength(head, file, fs::file_size(file, error));
}

Result<void> checkWritable(const fs::path& file) {
    std::error_code error;
    const fs::perms anyWrite = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    const bool marked = (fs::status(file, error).permissions() & anyWrite) == fs::perms::none;
    if (!fs::exists(file, error))
        return failure("The project file no longer exists", file.string(), "Save it under another name");
    if (!marked && mayWrite(file)) return {};
    return failure("The project file is read-only", file.string(), "Save it under another name");
}

std::string newId() {
    std::random_device random;
    return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

// Turns exceptions of SQLite and of the readers into an Error; no exception leaves this file.
template <class Work>
auto guarded(const fs::path& file, Work&& work) -> decltype(work()) try {
    return work();
} catch (const DatabaseError& error) {
    return tl::make_unexpected(errorOf(error, file));
} catch (const std::exception& error) {
    return failure(fmt::format("The project file cannot be used ({})", error.what()), file.string(),
                   "Check that there is enough memory and disk space");
}

void prepareToWrite(Database& database) {
    database.execute("PRAGMA journal_mode = DELETE; PRAGMA synchronous = FULL;");
}

void noteSave(Database& database, std::int64_t saves) {
    setFact(database, "saves", std::to_string(saves));
    setFact(database, "program", "Noonmark " + std::string(version()));
    setFact(database, "saved_at", *database.value("SELECT strftime('%Y-%m-%dT%H:%M:%fZ','now')"));
}

std::int64_t savesIn(Database& database) { return std::atoll(readFact(database, "saves").c_str()); }

Result<void> checkVersion(Database& database, const fs::path& file) {
    const int version = versionOf(database);
    if (version == schemaVersion || (version > 0 && version < schemaVersion)) return {};
    if (version == 0)
        return failure("It is a GeoPackage, but not a Noonmark project", file.string(),
                       "To start a project with its buildings: noonmark-cli project new");
    return failure(
        fmt::format(
            "The project was written by a newer Noonmark (version {} of the file; this program knows {})",
            version, schemaVersion),
        file.string(), "Install the newer program; the file was not changed");
}

void writeNew(const fs::path& file, const Project& project, const std::string& id) {
    Database database(file, Database::Access::create);
    prepareToWrite(database);
    Transaction transaction(database);
    createSchema(database, localCrsWkt(project.city->frame));
    setFact(database, "project_id", id);
    writeChanges(database, nullptr, project);
    noteSave(database, 1);
    transaction.commit();
}

Project readChecked(Database& database) {
    checkTables(database);
    return readProject(database);
}

// An older file is migrated in a copy in memory, so that a read-only file can be opened, too.
Project readAnyVersion(Database& database) {
    if (versionOf(database) == schemaVersion) return readChecked(database);
    Database copy(Database::InMemory{}, database);
    migrate(copy);
    return readChecked(copy);
}

Result<void> isOurs(Database& database, const ProjectFile& file) {
    if (auto known = checkVersion(database, file.path()); !known) return known;
    if (readFact(database, "project_id") == file.id() && savesIn(database) == file.saves()) return {};
    return failure("The project was saved by someone else since it was opened", file.path().string(),
                   "Save under another name, or open it again");
}

}  // namespace

Result<ProjectFile> ProjectFile::create(const fs::path& file, const Project& project, IfExists ifThere) {
    if (auto sound = validate(project); !sound) return tl::make_unexpected(sound.error());
    std::error_code ignored;
    if (ifThere == IfExists::refuse && fs::exists(file, ignored))
        return failure("There is a file of this name already", file.string(), "Choose another name");
    if (isBeingWritten(file))  // SQLite would apply the journal of an older file to the new one
        return failure("The journal of another file lies here", file.string() + "-journal",
                       "Remove it, or choose another name");
    return guarded(file, [&]() -> Result<ProjectFile> {
        PendingFile pending(file);
        ProjectFile made;
        made.path_ = file;
        made.project_ = project;
        made.id_ = newId();
        made.saves_ = 1;
        writeNew(pending.path(), project, made.id_);
        if (auto named = pending.commit(); !named) return tl::make_unexpected(named.error());
        return made;
    });
}

Result<ProjectFile> ProjectFile::open(const fs::path& file) {
    if (auto whole = checkWhole(file); !whole) return tl::make_unexpected(whole.error());
    return guarded(file, [&]() -> Result<ProjectFile> {
        // Rolling back an unfinished transaction of a killed process needs write access.
        const bool writable = bool(checkWritable(file));
        Database database(file, writable ? Database::Access::write : Database::Access::read);
        database.limitValues(file);
        const Transaction transaction(database, false);
        if (auto known = checkVersion(database, file); !known) return tl::make_unexpected(known.error());
        ProjectFile opened;
        opened.path_ = file;
        opened.id_ = readFact(database, "project_id");
        opened.saves_ = savesIn(database);
        opened.project_ = readAnyVersion(database);
        if (auto sound = validate(opened.project_); !sound)
            throwDamaged(fmt::format("{}: {}", sound.error().where, sound.error().what));
        return opened;
    });
}

bool ProjectFile::isUnchanged() const {
    const Result<void> ours = guarded(path_, [&]() -> Result<void> {
        Database database(path_, Database::Access::read);
        return isOurs(database, *this);
    });
    return bool(ours);
}

Result<void> ProjectFile::save(const Project& project) {
    if (auto sound = validate(project); !sound) return sound;
    if (auto writable = checkWritable(path_); !writable) return writable;
    if (auto whole = checkWhole(path_); !whole) return whole;
    return guarded(path_, [&]() -> Result<void> {
        Database database(path_, Database::Access::write);
        prepareToWrite(database);
        Transaction transaction(database);
        if (auto ours = isOurs(database, *this); !ours) return ours;
        migrate(database);
        checkTables(database);
        removeSpatialIndexes(database);
        restoreTableDefinitions(database);
        writeChanges(database, &project_, project);
        noteSave(database, saves_ + 1);
        transaction.commit();
        project_ = project;
        ++saves_;
        return {};
    });
}

namespace {

// What a save that was killed leaves beside the file: its last part, without which the file is torn.
fs::path journalOf(const fs::path& file) { return file.string() + "-journal"; }

}  // namespace

fs::path recoveryPath(const fs::path& file) {
    std::string name = file.filename().string();
    if (name.ends_with(projectEnding)) name.resize(name.size() - std::string_view(projectEnding).size());
    return file.parent_path() / ("." + name + ".recovery" + projectEnding);
}

void removeProject(const fs::path& file) {
    std::error_code ignored;
    fs::remove(file, ignored);
    fs::remove(journalOf(file), ignored);
}

void moveProject(const fs::path& from, const fs::path& to) {
    removeProject(to);
    std::error_code none;
    if (fs::exists(journalOf(from), none)) fs::rename(journalOf(from), journalOf(to), none);
    fs::rename(from, to, none);
}

Result<void> Autosave::keep(const Project& project) {
    if (saved_) return saved_->save(project);
    std::error_code none;
    fs::remove(journalOf(path_), none);  // of the file that is replaced now
    auto made = ProjectFile::create(path_, project, ProjectFile::IfExists::replace);
    if (!made) return tl::make_unexpected(made.error());
    saved_ = *std::move(made);
    return {};
}

void Autosave::discard() {
    saved_.reset();
    removeProject(path_);
}

std::optional<Recovery> recoveryOf(const fs::path& file) {
    std::error_code error;
    const fs::path path = recoveryPath(file);
    if (!fs::exists(path, error)) return std::nullopt;
    const auto recovered = fs::last_write_time(path, error);
    const auto saved = fs::last_write_time(file, error);
    if (!error && saved > recovered) return std::nullopt;
    return Recovery{path, recovered};
}

}  // namespace noonmark
