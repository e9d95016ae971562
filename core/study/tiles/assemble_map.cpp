#include "core/study/tiles/assemble_map.h"

#include <limits>

#include "core/io/write_raster.h"

namespace noonmark {

namespace {

Result<void> copyTile(GeoTiffWriter& writer, const Grid& tile,
                      const std::optional<std::filesystem::path>& file, const TileMap& map) {
    const std::size_t bandCount = map.bands.size();
    if (!file) {
        const std::vector<float> nothing(tile.size(), std::numeric_limits<float>::quiet_NaN());
        return writer.write(tile, std::vector<const std::vector<float>*>(bandCount, &nothing));
    }
    return readGeoTiff(*file, tile).and_then([&](const std::vector<std::vector<float>>& bands) {
        if (bands.size() < map.firstBand + bandCount)
            return Result<void>(failure("A tile has too few bands", file->string(),
                                        "Remove this file, and run the study again"));
        std::vector<const std::vector<float>*> copied;
        for (std::size_t band = 0; band < bandCount; ++band) copied.push_back(&bands[map.firstBand + band]);
        return writer.write(tile, copied);
    });
}

}  // namespace

TileFiles listFiles(const TileJournal& journal) {
    TileFiles files;
    for (const auto& [number, result] : journal.finished())
        files[number] = result.empty() ? std::nullopt : std::optional(journal.fileOf(result));
    return files;
}

Result<void> assembleMap(const TilePlan& plan, const TileFiles& tiles, const Frame& frame,
                         const MapFile& file, const TileMap& map, Progress& progress,
                         const std::stop_token& stop) {
    auto writer = GeoTiffWriter::create(file.path, frame, plan.whole, map.bands, file.tags);
    if (!writer) return tl::make_unexpected(writer.error());
    for (std::size_t number = 0; number < plan.count(); ++number) {
        if (stop.stop_requested()) return cancelled();
        progress.report(double(number) / double(plan.count()), "writing the map");
        const auto found = tiles.find(number);
        auto copied =
            copyTile(*writer, plan.tile(number), found == tiles.end() ? std::nullopt : found->second, map);
        if (!copied) return copied;
    }
    return writer->finish(file.overviews, stop);
}

}  // namespace noonmark
