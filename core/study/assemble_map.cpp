#include "core/study/assemble_map.h"

#include <limits>

#include "core/io/write_raster.h"
#include "core/study/map_bands.h"

namespace noonmark {

namespace {

Result<void> copyTile(GeoTiffWriter& map, const Grid& tile, const std::filesystem::path& file, bool empty) {
    if (empty) {
        const std::vector<float> nothing(tile.size(), std::numeric_limits<float>::quiet_NaN());
        return map.write(tile, {&nothing, &nothing});
    }
    return readGeoTiff(file, tile).and_then([&](const std::vector<std::vector<float>>& bands) {
        return map.write(tile, {&bands.at(0), &bands.at(1)});
    });
}

}  // namespace

Result<void> assembleMap(const TilePlan& plan, const TileJournal& journal, const Frame& frame,
                         const std::filesystem::path& file, Progress& progress, const std::stop_token& stop) {
    const ShadowField names;
    auto map = GeoTiffWriter::create(file, frame, plan.whole, mapBands(names));
    if (!map) return tl::make_unexpected(map.error());
    for (const auto& [number, result] : journal.finished()) {
        if (stop.stop_requested()) return cancelled();
        progress.report(double(number) / double(plan.count()), "writing the map");
        auto copied = copyTile(*map, plan.tile(number), journal.fileOf(number), result.empty());
        if (!copied) return copied;
    }
    return map->finish(true, stop);
}

}  // namespace noonmark
