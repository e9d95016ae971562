#include "core/io/archives/unpack_archive.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <iterator>
#include <optional>

#include "core/base/progress.h"
#include "core/base/safe_text.h"
#include "core/describe/text.h"
#include "core/io/files/plain_file.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

namespace {

constexpr const char* unpackAdvice = "Unpack it yourself if you trust it, and name the files in it";

// Names with a backslash are those of Windows; a drive or a stream would have a colon.
bool leadsOut(const std::string& name) {
    const std::filesystem::path path(name);
    const auto isUp = [](const std::filesystem::path& step) { return step == ".."; };
    return path.is_absolute() || name.find_first_of("\\:") != name.npos || name.find('\0') != name.npos ||
           std::any_of(path.begin(), path.end(), isUp);
}

}  // namespace

UnpackedFile::UnpackedFile(std::filesystem::path path, UnpackBudget& budget)
    : path_(std::move(path)), stream_(path_, std::ios::binary), budget_(&budget) {}

Result<UnpackedFile> UnpackedFile::create(const std::filesystem::path& folder, const std::string& name,
                                          UnpackBudget& budget) {
    if (leadsOut(name))
        return failure(
            fmt::format("The archive holds a file \"{}\", outside of its own folder", cleanText(name)), {},
            "Do not trust it");
    if (++budget.files > budget.limits.files)
        return limitReached(fmt::format("The archive holds more than {} files", budget.limits.files), {},
                            unpackAdvice);
    const std::filesystem::path path = folder / name;
    std::error_code error;
    std::filesystem::create_directories(path.parent_path(), error);
    if (std::filesystem::exists(path, error))
        return failure(fmt::format("The archive holds two files \"{}\"", cleanText(name)), {},
                       "Pack it again");
    UnpackedFile file(path, budget);
    if (!file.stream_) return failure(fmt::format("\"{}\" cannot be unpacked", cleanText(name)));
    return file;
}

Result<void> UnpackedFile::write(std::span<const char> bytes) {
    budget_->bytes += bytes.size();
    const UnpackLimits& limits = budget_->limits;
    const bool tooDense = budget_->bytes > limits.anyRatio &&
                          double(budget_->bytes) > limits.ratio * double(budget_->packedBytes);
    if (budget_->bytes > limits.bytes || tooDense)
        return limitReached(
            tooDense ? fmt::format("The archive grows to more than {:g} times its size", limits.ratio)
                     : fmt::format("The archive grows to more than {:.1f} GB", double(limits.bytes) / 1e9),
            {}, unpackAdvice);
    stream_.write(bytes.data(), std::streamsize(bytes.size()));
    if (stream_) return {};
    return failure("The archive cannot be unpacked: is the disk full?", path_.parent_path().string(),
                   "Make room, or state a folder with more in TMPDIR");
}

Result<void> UnpackedFile::close() {
    stream_.close();
    if (stream_) return {};
    return write({});
}

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

// Why an archive has no city: what is in it, where that is known by name.
Error describeUnreadable(const fs::path& folder) {
    for (const fs::path& file : listFiles(folder))
        if (const Format* foreign =
                fs::is_regular_file(file) ? findForeignFormat(readFileHead(file)) : nullptr)
            return {fmt::format("The archive holds \"{}\": this is {}, which is not read",
                                cleanText(file.filename().string()), foreign->name),
                    {},
                    std::string(foreign->instead),
                    ErrorKind::unsupported};
    return {"The archive holds no file of a format that is read",
            {},
            "Unpack it, and look at what is in it",
            ErrorKind::unsupported};
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
    if (files.empty()) return tl::make_unexpected(describeUnreadable(folder));
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

namespace {

template <class List>
void moveTo(List& all, List& some) {
    std::ranges::move(some, std::back_inserter(all));
}

/// Adds a tile to the tiles before it.
void join(FilePiece& all, FilePiece tile) {
    const std::size_t before = all.buildings.size();
    const bool haveRoofs = !all.roofs.empty() || !tile.roofs.empty();
    moveTo(all.buildings, tile.buildings);
    all.groundM.resize(before);
    moveTo(all.groundM, tile.groundM);
    all.groundM.resize(all.buildings.size());
    if (haveRoofs) {
        all.roofs.resize(before);
        moveTo(all.roofs, tile.roofs);
        all.roofs.resize(all.buildings.size());
    }
    moveTo(all.trees, tile.trees);
    moveTo(all.warnings, tile.warnings);
    moveTo(all.heights.fields, tile.heights.fields);
    moveTo(all.heights.unknown, tile.heights.unknown);
    moveTo(all.heights.doubts, tile.heights.doubts);
    all.features += tile.features;
    all.ownZero = all.ownZero || tile.ownZero;
    if (!all.frame) all.frame = tile.frame;
    if (tile.terrain && all.terrain)
        all.warnings.push_back({WarningKind::leftOut, "a second terrain in the archive", all.format});
    if (!all.terrain) {
        all.terrain = std::move(tile.terrain);
        all.unknownPosts = std::move(tile.unknownPosts);
    }
    if (all.format.empty()) all.format = std::move(tile.format);
    if (all.crs.empty()) all.crs = std::move(tile.crs);
    if (all.attribution.empty()) all.attribution = std::move(tile.attribution);
}

Result<FilePiece> readPacked(const std::filesystem::path& file, const ReadSettings& settings,
                             Progress& progress, const std::stop_token& stop, const LonLatBox* window) {
    const auto format = detectFormat(file);
    if (!format) return tl::make_unexpected(format.error());
    auto piece = (*format)->reader.read(file, settings, progress, stop, window);
    if (piece && (*format)->driver == "OSM")
        piece->warnings.push_back({WarningKind::leftOut, "the water of a map in an archive",
                                   file.filename().string() + " (unpack it to have it read)"});
    return piece;
}

}  // namespace

Result<FilePiece> readArchive(const std::filesystem::path& file, const ReadSettings& given,
                              Progress& progress, std::stop_token stop, const LonLatBox* window) {
    progress.report(0, NM_TEXT("unpacking the archive"));
    const auto archive = unpackArchive(file, stop);
    if (!archive) return tl::make_unexpected(archive.error());
    ReadSettings settings = given;
    FilePiece all;
    for (std::size_t i = 0; i < archive->cities.size(); ++i) {
        ProgressShare share(progress, i, archive->cities.size());
        auto piece = readPacked(archive->cities[i], settings, share, stop, window);
        if (!piece) {
            Error error = std::move(piece.error());
            if (!isCancelled(error))
                error.where = file.string() + ": " + archive->cities[i].filename().string();
            return tl::make_unexpected(std::move(error));
        }
        if (!settings.frame) settings.frame = piece->frame;
        join(all, *std::move(piece));
    }
    return all;
}

}  // namespace noonmark
