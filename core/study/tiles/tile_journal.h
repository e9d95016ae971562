#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/locked_file.h"
#include "core/receivers/tile_plan.h"
#include "core/study/tiles/tile_result.h"

namespace noonmark {

/// The finished tiles of a study, stored in a folder: journal.jsonl, whose first line identifies the study by
/// its hash and whose other lines are one TileResult each, and a GeoTIFF per tile. If the process is killed,
/// the next one finds the finished tiles; a truncated line or file counts as missing. One process at a time.
class TileJournal {
public:
    /// Creates the folder or opens an existing one. Error: it belongs to another study, another process works
    /// on it, or it cannot be written.
    static Result<TileJournal> open(const std::filesystem::path& folder, const std::string& studyHash,
                                    const TilePlan& plan);

    /// The finished tiles of a folder that another process may be writing to; none if it does not exist. Does
    /// not lock or change anything. Error: it belongs to another study.
    static Result<std::map<std::size_t, TileResult>> peek(const std::filesystem::path& folder,
                                                          const std::string& studyHash, const TilePlan& plan);

    /// By tile number.
    [[nodiscard]] const std::map<std::size_t, TileResult>& finished() const { return finished_; }

    /// The file of a tile: its cells in the bands of all maps (tile_maps.h), or its lines of JSON. Empty
    /// tiles have none.
    [[nodiscard]] std::filesystem::path fileOf(const TileResult& tile) const;
    /// The same for a journal in this folder.
    static std::filesystem::path fileIn(const std::filesystem::path& folder, const TileResult& tile);

    /// Marks a tile as finished; its file must exist.
    Result<void> add(TileResult result);

    /// Removes the folder and its content.
    void remove();

private:
    TileJournal(std::filesystem::path folder, std::optional<LockedFile> file);
    Result<void> read(const std::string& text, const std::string& first, const TilePlan& plan);
    Result<void> append(const std::string& line);
    void take(const std::string& line, const TilePlan& plan);

    std::filesystem::path folder_;
    std::optional<LockedFile> file_;  ///< none while only reading
    std::map<std::size_t, TileResult> finished_;
};

}  // namespace noonmark
