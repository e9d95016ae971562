#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/describe/answer_page.h"
#include "core/describe/figure.h"
#include "core/describe/figure_text.h"
#include "core/io/elements/write_elements.h"
#include "core/study/elements/element_map.h"
#include "core/study/provenance/command_text.h"
#include "core/study/provenance/provenance_texts.h"

namespace noonmark {

/// One row for each point, in the order of the receivers: id, kind, building, building_name, floor,
/// azimuth_deg (that it faces, from true north; empty where it faces up or down), lon_deg, lat_deg,
/// elevation_m, above_ground_m, sunlit_min (minutes of sun a day, mean over the days), sunlit_pct (of the
/// time with the sun up), gross_min and continuous_min (shadow, as in a study of cells), longest_sun_min, a
/// column sunlit_min_01 to sunlit_min_12 for each month of the period (minutes in all), the same with trees
/// (sunlit_min_evergreen, sunlit_min_01_evergreen), and the source columns
/// (core/study/provenance/provenance_texts.h).
ElementTable makeElementTable(const ElementStudy& study);

/// The same of results that are read back: `city` is the one that was measured, `source` the source columns'
/// values (sourceValues()).
ElementTable makeElementTable(const ElementMap& map, const City& city, const SourceValues& source);

/// The style of the points for QGIS, in the colours of a map of their gross shadow: by gross_min, sunlit_min
/// or sunlit_pct, as the scale shows, of the columns that end with `suffix` (suffixOf()).
LayerStyle makeStyle(const ColourScale& scale, const std::string& suffix = {});

/// The table as CSV (RFC 4180), in metres, minutes and degrees with fixed digits.
std::string toCsv(const ElementTable& table);

/// study.json of points. Keys that a study of cells has, too, mean the same; `elements` says where the points
/// are. `writeSeconds`: of the files that were written before.
std::string elementStudyJson(const ElementStudy& study, const std::map<std::string, double>& writeSeconds);

/// Figures of all points together.
struct ElementFigures {
    std::size_t points = 0;
    double possibleMin = 0;                                        ///< minutes a day with the sun up
    double meanSunlitMin = 0, minSunlitMin = 0, maxSunlitMin = 0;  ///< a day
    double meanGrossMin = 0;                                       ///< a day
    double meanContinuousMin = 0, maxContinuousMin = 0;
};
ElementFigures computeFigures(const ElementStudy& study);
const Figures<ElementFigures>& elementFigures();

/// Those with trees of one column.
struct ShadedElementFigures {
    TreeColumns column = TreeColumns::seasonal;  ///< or evergreen
    ElementFigures figures;
};
/// Evergreens first; empty where the study has none.
std::vector<ShadedElementFigures> listFiguresWithTrees(const ElementStudy& study);
/// "mean_sunlit_min_evergreen"
std::span<const Figure> elementFiguresWithTrees(TreeColumns column);
/// The figures for people: without trees, then with them.
std::vector<FigureLine> listElementLines(const ElementFigures& figures,
                                         std::span<const ShadedElementFigures> withTrees,
                                         FigureContext context = {});

/// What points say: hours of sun on average, at the darkest and the sunniest, and how they divide into hours.
AnswerPage makePage(const ElementMap& map, const ElementFigures& figures);

/// A point of a map, for the figures of its row.
struct MapPoint {
    const ElementMinutes* minutes = nullptr;
    double possibleMin = 0;  ///< ElementMap::possibleMin
};
/// The numbers that are measured at each point; without those of months.
const Figures<MapPoint>& pointFigures();
/// The same with trees: "sunlit_min_evergreen".
std::span<const Figure> pointFiguresWithTrees(TreeColumns column);

}  // namespace noonmark
