#include "core/study/tiles/tile_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/describe/text.h"
#include "core/engines/shade_trees.h"

namespace noonmark {

namespace {

TileMap mapOfMonths(const SunSteps& sun, std::size_t firstBand) {
    TileMap map{
        .name = std::string(monthMap), .title = "Shadow by month", .bands = {}, .firstBand = firstBand};
    for (const std::string& month : monthsOf(sun).names) map.bands.push_back({month, "min", nullptr});
    return map;
}

}  // namespace

LegendChoice withoutQuantiles(LegendChoice legend) {
    for (LegendClasses* classes : {&legend.classes, &legend.changeClasses})
        if (classes->kind == LegendClasses::Kind::quantiles) classes->kind = LegendClasses::Kind::equal;
    return legend;
}

ColourScale makeShadowScale(const ShadowStatistics& figures, double sunlitMinutesPerDay,
                            const LegendChoice& legend) {
    return makeColourScale(withoutQuantiles(legend), {legend.show, sunlitMinutesPerDay},
                           std::max(sunlitMinutesPerDay, figures.maxGrossMin), {});
}

ColourScale makeMonthScale(const SunSteps& sun, const LegendChoice& legend) {
    LegendChoice ofMonths = withoutQuantiles(legend);
    ofMonths.range.reset();
    if (ofMonths.classes.kind == LegendClasses::Kind::breaks) ofMonths.classes = {};
    const std::vector<double> sunlit = monthsOf(sun).sunlitMinutes(sun);
    return makeColourScale(ofMonths, {}, sunlit.empty() ? 0 : std::ranges::max(sunlit), {});
}

namespace {

// A map with trees of a column, whose bands follow the others in the files of tiles.
TileMap mapWithTrees(TileMap map, TreeColumns column, std::size_t firstBand) {
    map.withoutTrees = std::exchange(map.firstBand, firstBand);
    map.name += suffixOf(column);
    map.title += fmt::format(", {}", describeTrees(column));
    for (RasterBand& band : map.bands) band.name += fmt::format(", {}", describeTrees(column));
    return map;
}

}  // namespace

std::vector<TileMap> listTileMaps(const StudySettings& settings, const SunSteps& sun, TreeColumns columns) {
    const ShadowField names;
    std::vector<TileMap> maps{
        {.name = "shadow", .title = "Shadow", .bands = makeMapBands(names, true), .runBands = 1}};
    for (RasterBand& band : maps.front().bands) band.values = nullptr;
    if (settings.byMonth) maps.push_back(mapOfMonths(sun, maps.front().bands.size()));
    return addMapsWithTrees(std::move(maps), columns);
}

std::vector<TileMap> addMapsWithTrees(std::vector<TileMap> maps, TreeColumns columns) {
    const std::vector<TileMap> without = maps;
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        for (const TileMap& map : without)
            if (isAmong(columns, column))
                maps.push_back(mapWithTrees(map, column, maps.back().firstBand + maps.back().bands.size()));
    return maps;
}

std::vector<TileMap> listWrittenMaps(std::vector<TileMap> maps, bool runs, bool runsWithTrees) {
    for (TileMap& map : maps)
        if (!(map.withoutTrees ? runsWithTrees : runs)) map.bands.resize(map.bands.size() - map.runBands);
    return maps;
}

namespace {

Result<void> copyTile(GeoTiffWriter& writer, const Grid& tile, const std::optional<TileFile>& file,
                      const TileMap& map) {
    const std::size_t bandCount = map.bands.size();
    if (!file) {
        const std::vector<float> nothing(tile.size(), std::numeric_limits<float>::quiet_NaN());
        return writer.write(tile, std::vector<const std::vector<float>*>(bandCount, &nothing));
    }
    return readGeoTiff(file->path, tile).and_then([&](const std::vector<std::vector<float>>& bands) {
        const std::size_t first = file->firstBandOf(map);
        if (bands.size() < first + bandCount)
            return Result<void>(failure("A tile has too few bands", file->path.string(),
                                        "Remove this file, and run the study again"));
        std::vector<const std::vector<float>*> copied;
        for (std::size_t band = 0; band < bandCount; ++band) copied.push_back(&bands[first + band]);
        return writer.write(tile, copied);
    });
}

}  // namespace

TileFiles listFiles(const TileJournal& journal) {
    TileFiles files;
    for (const auto& [number, result] : journal.finished())
        files[number] = result.empty()
                            ? std::nullopt
                            : std::optional(TileFile{journal.fileOf(result), !result.withTrees.empty()});
    return files;
}

Result<void> assembleMap(const TilePlan& plan, const TileFiles& tiles, const Frame& frame,
                         const MapFile& file, const TileMap& map, Progress& progress,
                         const std::stop_token& stop) {
    auto writer = GeoTiffWriter::create(file.path, frame, plan.whole, map.bands, file.tags);
    if (!writer) return tl::make_unexpected(writer.error());
    for (std::size_t number = 0; number < plan.count(); ++number) {
        if (stop.stop_requested()) return cancelled();
        progress.report(double(number) / double(plan.count()), NM_TEXT("writing the map"));
        const auto found = tiles.find(number);
        auto copied =
            copyTile(*writer, plan.tile(number), found == tiles.end() ? std::nullopt : found->second, map);
        if (!copied) return copied;
    }
    return writer->finish(file.overviews, stop);
}

}  // namespace noonmark
