#include "core/study/tiles/tile_maps.h"

#include <algorithm>

#include "core/study/tiles/map_bands.h"

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

std::vector<TileMap> listTileMaps(const StudySettings& settings, const SunSteps& sun) {
    const ShadowField names;
    std::vector<TileMap> maps{
        {.name = "shadow", .title = "Shadow", .bands = makeMapBands(names, true), .runBands = 1}};
    for (RasterBand& band : maps.front().bands) band.values = nullptr;
    if (settings.byMonth) maps.push_back(mapOfMonths(sun, maps.front().bands.size()));
    return maps;
}

std::vector<TileMap> listWrittenMaps(std::vector<TileMap> maps, bool runs) {
    for (TileMap& map : maps)
        if (!runs) map.bands.resize(map.bands.size() - map.runBands);
    return maps;
}

}  // namespace noonmark
