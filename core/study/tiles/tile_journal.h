#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/receivers/tile_plan.h"
#include "core/study/tiles/tile_result.h"

namespace noonmark {

/// The finished tiles of a study in a folder: journal.jsonl, whose first line names the study by its hash and
/// each other line is one TileResult, and a GeoTIFF a tile. Who opens it again after a kill finds what was
/// finished; a line or a file that was cut off counts as not there. One process at a time.
class TileJournal {
public:
    /// Makes the folder or opens the one that is there. Error: it belongs to another study, another process
    /// works on it, or it can't be written.
    static Result<TileJournal> open(const std::filesystem::path& folder, const std::string& studyHash,
                                    const TilePlan& plan);
    TileJournal(TileJournal&& other) noexcept;
    TileJournal& operator=(TileJournal&& other) noexcept = delete;
    ~TileJournal();

    /// By number.
    [[nodiscard]] const std::map<std::size_t, TileResult>& finished() const { return finished_; }

    /// Where the cells of a tile are kept: two bands, gross and continuous minutes. Empty tiles have none.
    [[nodiscard]] std::filesystem::path fileOf(std::size_t tile) const;

    /// The tile's file is there; from now on it counts as finished.
    Result<void> add(TileResult result);

    /// Removes the folder and all that is in it.
    void remove();

private:
    TileJournal(std::filesystem::path folder, int file);
    Result<void> read(const std::string& text, const std::string& first, const TilePlan& plan);
    Result<void> append(const std::string& line);
    void take(const std::string& line, const TilePlan& plan);

    std::filesystem::path folder_;
    int file_ = -1;
    std::map<std::size_t, TileResult> finished_;
};

}  // namespace noonmark
