#include "core/study/tiles/assemble_map.h"

#include <limits>

#include "core/io/write_raster.h"
#include "core/study/tiles/map_bands.h"

namespace noonmark {

namespace {

Result<void> copyTile(GeoTiffWriter& map, const Grid& tile, const std::optional<std::filesystem::path>& file,
                      std::size_t bandCount) {
    if (!file) {
        const std::vector<float> nothing(tile.size(), std::numeric_limits<float>::quiet_NaN());
        return map.write(tile, std::vector<const std::vector<float>*>(bandCount, &nothing));
    }
    return readGeoTiff(*file, tile).and_then([&](const std::vector<std::vector<float>>& bands) {
        std::vector<const std::vector<float>*> copied;
        for (std::size_t band = 0; band < bandCount; ++band) copied.push_back(&bands.at(band));
        return map.write(tile, copied);
    });
}

}  // namespace

TileFiles listFiles(const TileJournal& journal) {
    TileFiles files;
    for (const auto& [number, result] : journal.finished())
        files[number] = result.empty() ? std::nullopt : std::optional(journal.fileOf(number));
    return files;
}

Result<void> assembleMap(const TilePlan& plan, const TileFiles& tiles, const Frame& frame,
                         const MapFile& file, bool runs, Progress& progress, const std::stop_token& stop) {
    const ShadowField names;
    const std::vector<RasterBand> bands = makeMapBands(names, runs);
    auto map = GeoTiffWriter::create(file.path, frame, plan.whole, bands, file.tags);
    if (!map) return tl::make_unexpected(map.error());
    for (std::size_t number = 0; number < plan.count(); ++number) {
        if (stop.stop_requested()) return cancelled();
        progress.report(double(number) / double(plan.count()), "writing the map");
        const auto found = tiles.find(number);
        auto copied = copyTile(*map, plan.tile(number), found == tiles.end() ? std::nullopt : found->second,
                               bands.size());
        if (!copied) return copied;
    }
    return map->finish(file.overviews, stop);
}

}  // namespace noonmark
