#include "core/study/tiles/tile_runner.h"

#include <fmt/format.h>
#include <algorithm>

#include "core/io/files/write_text.h"
#include "core/io/write_raster.h"
#include "core/study/provenance/provenance.h"
#include "core/study/study_cost.h"

namespace noonmark {

namespace {

std::vector<RasterBand> listBands(const std::vector<TileMap>& maps) {
    std::vector<RasterBand> bands;
    for (const TileMap& map : maps) bands.insert(bands.end(), map.bands.begin(), map.bands.end());
    return bands;
}

Result<TileResult> withFile(TileResult result, const std::filesystem::path& file,
                            const std::string& contentHash) {
    result.contentHash = contentHash;
    if (contentHash.empty() || result.empty()) return result;
    return describeInputFile(file).map([&](const InputFile& written) {
        result.fileBytes = written.bytes;
        result.fileSha256 = written.sha256;
        return std::move(result);
    });
}

}  // namespace

TileRunner::TileRunner(TileMeasure& measure, const TilePlan& plan, const Frame& frame, TileJournal& journal)
    : measure_(measure), plan_(plan), frame_(frame), journal_(journal), bands_(listBands(measure.maps())) {}

Result<void> TileRunner::run(std::size_t tile, Progress& progress, const std::stop_token& stop,
                             const std::string& contentHash) {
    const Stopwatch watch;
    return measure_.measure(plan_.tile(tile), progress, stop)
        .and_then([&](TileAnswer answer) -> Result<TileResult> {
            answer.result.number = tile;
            return write(answer).map([&] { return std::move(answer.result); });
        })
        .and_then([&](TileResult result) {
            result.seconds = watch.seconds();
            const std::filesystem::path file = journal_.fileOf(result);
            return withFile(std::move(result), file, contentHash);
        })
        .and_then([&](TileResult result) { return journal_.add(std::move(result)); });
}

Result<void> TileRunner::write(const TileAnswer& answer) const {
    const std::filesystem::path file = journal_.fileOf(answer.result);
    if (answer.result.lines > 0) return writeText(file, answer.lines);
    return answer.bands.empty() ? Result<void>() : writeMaps(file, answer);
}

Result<void> TileRunner::writeMaps(const std::filesystem::path& file, const TileAnswer& answer) const {
    const Grid grid = plan_.tile(answer.result.number);
    std::vector<RasterBand> bands = bands_;
    bands.resize(answer.bands.size());  // a tile that no tree reaches has none with trees
    auto writer = GeoTiffWriter::create(file, frame_, grid, bands);
    if (!writer) return tl::make_unexpected(writer.error());
    std::vector<const std::vector<float>*> pointers;
    for (const std::vector<float>& band : answer.bands) pointers.push_back(&band);
    return writer->write(grid, pointers).and_then([&] { return writer->finish(false); });
}

Result<void> runTiles(TileRunner& runner, const TilePlan& plan, const TilesLeft& left, Progress& progress,
                      const std::stop_token& stop) {
    const auto cellsOf = [&](const MissingTile& tile) { return double(plan.tile(tile.number).size()); };
    double cells = left.done.cells + left.later.cells;
    for (const MissingTile& tile : left.missing) cells += cellsOf(tile);
    PiecewiseProgress pieces(progress, cells, left.done.cells);
    const std::size_t count = left.done.tiles + left.missing.size() + left.later.tiles;
    std::size_t number = left.done.tiles;
    for (const MissingTile& tile : left.missing) {
        if (stop.stop_requested()) return cancelled();
        pieces.begin(fmt::format("tile {} of {}", ++number, count), cellsOf(tile));
        if (auto done = runner.run(tile.number, pieces, stop, tile.contentHash); !done) return done;
        pieces.end();
    }
    return {};
}

Result<void> checkTileMemory(const City& city, const TilePlan& plan, StudySettings settings,
                             const EngineList& engines) {
    const auto cellM = float(plan.whole.cellM);
    const float widthM = cellM * float(std::min(plan.side, plan.whole.columns));
    const float heightM = cellM * float(std::min(plan.side, plan.whole.rows));
    settings.region = makeRegionFromLocalBox({{0, 0}, {widthM, heightM}});
    return checkMemory(city, settings, engines);
}

}  // namespace noonmark
