#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/base/progress_share.h"
#include "core/io/archives/unpack_archive.h"
#include "core/io/files/file_kind.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

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
    moveTo(all.warnings, tile.warnings);
    moveTo(all.heights.fields, tile.heights.fields);
    moveTo(all.heights.unknown, tile.heights.unknown);
    moveTo(all.heights.doubts, tile.heights.doubts);
    all.features += tile.features;
    all.ownZero = all.ownZero || tile.ownZero;
    if (!all.frame) all.frame = tile.frame;
    if (tile.terrain && all.terrain)
        all.warnings.push_back({WarningKind::leftOut, "a second terrain in the archive", all.format});
    if (!all.terrain) all.terrain = std::move(tile.terrain);
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
    progress.report(0, "unpacking the archive");
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
