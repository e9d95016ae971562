#include "scenarios/project/project_file.h"

#include <fmt/format.h>

#include <cstdlib>
#include <random>

#include "core/base/version.h"
#include "core/io/files/geopackage_check.h"
#include "core/io/files/pending_file.h"
#include "scenarios/project/file_check.h"
#include "scenarios/project/read_project.h"
#include "scenarios/project/tables/grid_tiles.h"
#include "scenarios/project/tables/schema.h"
#include "scenarios/project/write_project.h"

namespace noonmark {

namespace {

namespace fs = std::filesystem;

std::string newId() {
    std::random_device random;
    return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

// Turns exceptions of SQLite and of the readers into an Error; no exception leaves this file.
template <class Work>
auto guarded(const fs::path& file, Work&& work) -> decltype(work()) try {
    return work();
} catch (const DatabaseTrouble& trouble) {
    return tl::make_unexpected(errorOf(trouble, file));
} catch (const std::exception& trouble) {
    return failure(fmt::format("The project file cannot be used ({})", trouble.what()), file.string(),
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

Result<ProjectFile> ProjectFile::create(const fs::path& file, const Project& project, IfThere ifThere) {
    if (auto sound = validate(project); !sound) return tl::make_unexpected(sound.error());
    std::error_code ignored;
    if (ifThere == IfThere::refuse && fs::exists(file, ignored))
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
        takeTablesBack(database);
        writeChanges(database, &project_, project);
        noteSave(database, saves_ + 1);
        transaction.commit();
        project_ = project;
        ++saves_;
        return {};
    });
}

}  // namespace noonmark
