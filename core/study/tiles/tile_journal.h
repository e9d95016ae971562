#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/working_files.h"
#include "core/engines/api/tree_shade.h"
#include "core/measures/error_sample.h"
#include "core/measures/statistics.h"
#include "core/receivers/tile_plan.h"

namespace noonmark {

/// What one tile has with trees of one column.
struct ShadedTile {
    TreeColumns column = TreeColumns::seasonal;  ///< or evergreen
    ShadowSums sums;
    std::vector<double> monthMinutes{};  ///< as TileResult::monthMinutes
};

/// The stored result of one tile of a study, except for its cells, which are in a raster file, or its lines
/// of JSON.
struct TileResult {
    std::size_t number = 0;  ///< tile number in the TilePlan
    ShadowSums sums;
    std::vector<double> monthMinutes{};  ///< of each month: sum over the receivers; empty unless wanted
    /// Sums that only some measures have, by name; their tiles are added up
    std::map<std::string, double> figures{};
    std::size_t lines = 0;  ///< of JSON in the tile's file; 0: the file is a raster
    bool hasTrees = false;  ///< an earlier version left out the trees of its city: it is to be measured again
    /// Evergreens first; empty: no tree reaches the tile, or none is wanted. Its file has the bands of the
    /// maps with trees then.
    std::vector<ShadedTile> withTrees{};
    std::string treesHow{};  ///< in words
    Cost cost;
    std::string engineKey;  ///< key of the engine that computed it; empty if there was nothing to do
    std::string engine;     ///< its name for display
    std::vector<ComparedCell> compared;  ///< cells compared with the ray reference
    double seconds = 0;
    double errorSeconds = 0;  ///< the part of `seconds` spent on `compared`

    /// Hash of everything that the tile was computed from; empty if the journal's own study says it all
    std::string contentHash{};
    std::uintmax_t fileBytes = 0;  ///< size of the tile's file; 0: not known
    std::string fileSha256{};      ///< of the tile's file; empty: not known

    /// The sums with trees of a column, which are those without where no tree reaches the tile.
    [[nodiscard]] const ShadowSums& sumsOf(TreeColumns column) const;
    [[nodiscard]] const std::vector<double>& monthMinutesOf(TreeColumns column) const;

    /// Without a file.
    [[nodiscard]] bool empty() const { return sums.receivers == 0 && lines == 0; }
};

/// One line of a journal, from which the same value is read back, to the last bit.
nlohmann::json toJson(const TileResult& result);
/// Nothing if the JSON is not a TileResult.
std::optional<TileResult> tileResultFrom(const nlohmann::json& json);

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

    /// The finished tiles by their number.
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
