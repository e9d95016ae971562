#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/write_raster.h"
#include "core/measures/colour_scale.h"
#include "core/study/study.h"

namespace noonmark {

/// A raster that a study in tiles gives. The file of each tile holds the bands of all maps, one after the
/// other.
struct TileMap {
    std::string name;               ///< of its file, without ending: "shadow", "by_month"
    std::string title;              ///< for people
    std::vector<RasterBand> bands;  ///< names and units; no values
    std::size_t firstBand = 0;      ///< place of its first band in the files of tiles
    std::size_t runBands = 0;       ///< how many of its last bands hold continuous shadow, or its change
    std::optional<ColourScale> colours{};  ///< none: those of shadow, see makeShadowScale()
};

/// The colours of maps of shadow whose cells are never together in memory. Quantiles, which need them, become
/// as many equal classes.
ColourScale makeShadowScale(const ShadowStatistics& figures, double sunlitMinutesPerDay,
                            const LegendChoice& legend = {});
/// The colours of maps of months, which hold the minutes of shadow of the whole month: up to those with the
/// sun up in the month that has most of them. Range and typed classes of the legend, which are of a day, do
/// not count; quantiles as above.
ColourScale makeMonthScale(const SunSteps& sun, const LegendChoice& legend = {});
/// Of maps around zero whose cells are never together.
LegendChoice withoutQuantiles(LegendChoice legend);

inline constexpr std::string_view monthMap = "by_month";  ///< the name of that of months

/// The maps that the settings of a study ask for: `shadow` (gross and continuous), and `by_month`, with a
/// band for each month of the sun.
std::vector<TileMap> listTileMaps(const StudySettings& settings, const SunSteps& sun);

/// The maps to be written: without the bands of continuous shadow unless `runs`. Tiles always have them,
/// since whether runs were counted is decided for all tiles together.
std::vector<TileMap> listWrittenMaps(std::vector<TileMap> maps, bool runs);

}  // namespace noonmark
