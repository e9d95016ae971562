#include "core/io/archives/unpack_archive.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "core/base/clean_text.h"
#include "core/io/archives/unpacked_bytes.h"
#include "core/io/files/file_kind.h"

namespace noonmark {

namespace {

namespace fs = std::filesystem;
using Unpack = Result<void>(const fs::path&, const fs::path&, UnpackBudget&, const std::stop_token&);

/// What unpacks a file; null if it is no archive. Files of other formats (Excel) are ZIPs as well.
Unpack* unpackerOf(const fs::path& file) {
    if (!fs::is_regular_file(file)) return nullptr;
    const FileHead head = readFileHead(file);
    if (findForeignFormat(head) != nullptr) return nullptr;
    if (head.bytes.starts_with("PK\3\4")) return unpackZip;
    return head.bytes.starts_with("\x1F\x8B") ? unpackGzip : nullptr;
}

/// Files below a folder in the order of their names; geodatabases count as one.
std::vector<fs::path> listFiles(const fs::path& folder) {
    std::vector<fs::path> files;
    for (fs::recursive_directory_iterator entry(folder), end; entry != end; ++entry) {
        const bool isDatabase = entry->is_directory() && entry->path().extension() == ".gdb";
        if (isDatabase) entry.disable_recursion_pending();
        if (isDatabase || entry->is_regular_file()) files.push_back(entry->path());
    }
    std::ranges::sort(files);
    return files;
}

Result<void> unpackInto(const fs::path& file, const fs::path& folder, Unpack* unpack, UnpackBudget& budget,
                        const std::stop_token& stop, int depth = 1) {
    if (auto done = unpack(file, folder, budget, stop); !done) return done;
    for (const fs::path& inner : listFiles(folder)) {
        Unpack* const again = unpackerOf(inner);
        if (again == nullptr || depth >= budget.limits.nesting) continue;
        const fs::path below = inner.string() + ".unpacked";
        std::error_code ignored;
        fs::create_directory(below, ignored);
        if (auto done = unpackInto(inner, below, again, budget, stop, depth + 1); !done) return done;
        fs::remove(inner, ignored);
    }
    return {};
}

struct Readable {
    fs::path path;
    FileKind kind;
};

/// The files whose format is read, but those that are read along with another.
std::vector<Readable> findReadable(const fs::path& folder) {
    std::vector<Readable> readable;
    std::vector<fs::path> companions;
    for (const fs::path& file : listFiles(folder))
        if (const auto kind = detectFileKind(file); kind && unpackerOf(file) == nullptr) {
            readable.push_back({file, *kind});
            std::ranges::move(listCompanionFiles(file), std::back_inserter(companions));
        }
    std::erase_if(readable, [&](const Readable& one) {
        return std::ranges::find(companions, one.path) != companions.end();
    });
    return readable;
}

/// Several Shapefiles in one folder are the layers of one map.
std::optional<fs::path> folderOfShapefiles(const std::vector<fs::path>& files) {
    const fs::path folder = files.front().parent_path();
    const bool are = std::ranges::all_of(files, [&](const fs::path& file) {
        return file.parent_path() == folder && readFileHead(file).ending == ".shp";
    });
    return are ? std::optional(folder) : std::nullopt;
}

Result<std::vector<fs::path>> findCities(const fs::path& folder) {
    const std::vector<Readable> readable = findReadable(folder);
    std::vector<std::string> names;
    std::vector<fs::path> files;
    for (const Readable& one : readable) {
        files.push_back(one.path);
        names.push_back(cleanText(one.path.lexically_relative(folder).string()));
    }
    const bool areTiles =
        std::ranges::all_of(readable, [](const Readable& one) { return one.kind == FileKind::cityJson; });
    if (files.empty())
        return unsupported("The archive holds no file of a format that is read", {},
                           "Unpack it, and look at what is in it");
    if (files.size() == 1 || areTiles) return files;
    if (const auto layers = folderOfShapefiles(files)) return std::vector{*layers};
    constexpr std::size_t mostNamed = 5;
    names.resize(std::min(names.size(), mostNamed));
    return failure(fmt::format("The archive holds {} files that could be the city: {}{}", files.size(),
                               fmt::join(names, ", "), files.size() > names.size() ? ", ..." : ""),
                   {}, "Unpack it, and name those that you want");
}

Result<UnpackedArchive> unpackWith(Unpack* unpack, const fs::path& file, const UnpackLimits& limits,
                                   const std::stop_token& stop) {
    UnpackedArchive archive{PrivateFolder(fs::temp_directory_path()), {}};
    if (archive.folder.path().empty())
        return failure("No folder for the unpacked files can be made", fs::temp_directory_path().string(),
                       "State another one in TMPDIR");
    UnpackBudget budget{limits, fs::file_size(file)};
    if (auto done = unpackInto(file, archive.folder.path(), unpack, budget, stop); !done)
        return tl::make_unexpected(done.error());
    auto cities = findCities(archive.folder.path());
    if (!cities) return tl::make_unexpected(cities.error());
    archive.cities = *std::move(cities);
    return archive;
}

}  // namespace

Result<UnpackedArchive> unpackArchive(const fs::path& file, const std::stop_token& stop,
                                      const UnpackLimits& limits) try {
    Unpack* const unpack = unpackerOf(file);
    if (unpack == nullptr) return failure("This is no archive", file.string());
    auto archive = unpackWith(unpack, file, limits, stop);
    if (archive || isCancelled(archive.error())) return archive;
    Error error = std::move(archive.error());
    if (error.where.empty()) error.where = file.string();
    return tl::make_unexpected(std::move(error));
} catch (const std::filesystem::filesystem_error& problem) {
    return failure("The archive cannot be unpacked: " + problem.code().message(), file.string());
}

}  // namespace noonmark
