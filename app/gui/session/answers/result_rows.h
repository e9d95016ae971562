#pragma once

#include <QString>
#include <vector>

#include "core/describe/answer_page.h"
#include "core/describe/figure_text.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/contributions/place_contributions.h"
#include "core/study/elements/element_map.h"
#include "core/study/elements/element_tables.h"
#include "core/study/text/error_text.h"
#include "core/sun/stated_period.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// A row of the results: name, value with unit, and meaning.
struct ResultRow {
    QString name;
    QString value;
    QString meaning;
    bool isMethod = false;  ///< how the result was made, not what it is
    QString subject{};      ///< id of the building or tree that its name leads to; empty: none
};

/// A row about how a result was made: period, steps, engine, error, time.
ResultRow methodRow(const QString& name, const QString& value, const QString& meaning = {});

/// A row for each figure in the user's language and units: label, value, and the definition as a tooltip.
/// What the figures refer to belongs to how they were made.
std::vector<ResultRow> figureRows(const std::vector<FigureLine>& lines);

/// A row for each error: of what, how much, and what it was measured on.
void addErrors(std::vector<ResultRow>& rows, std::span<const ShownError> errors);

/// The same in one text: "Weighted shade +10 m² h, Shadow area 9 m²".
QString joinFigures(const std::vector<FigureLine>& lines);

/// A sentence of a result in the user's language and units.
QString sentenceText(const Sentence& sentence);

/// The heading of a column of a figure: "Longest sun, h".
QString headingOf(const Figure& figure);

/// The meaning of the row of steps: "Positions of the sun above the horizon; 312 below it were left out".
QString describeSteps(std::uint64_t belowHorizon);

/// The figures of a study, new or saved.
struct StudyFigures {
    ShadowStatistics statistics;
    bool instant = false;            ///< of one moment: no minutes
    std::uint64_t steps = 0;         ///< steps with the sun above the horizon
    std::uint64_t belowHorizon = 0;  ///< steps left out
    double sunlitMinutesPerDay = 0;
    std::uint64_t rays = 0;
    double seconds = 0;  ///< engine time; 0: not known
    StatedPeriod period;
    std::vector<ErrorLine> errors;
    std::string engine;
    std::vector<ShownError> monthErrors{};                              ///< none: no months, or not measured
    std::vector<std::pair<TreeColumns, ShadowStatistics>> withTrees{};  ///< by column, where trees reach
};
std::vector<ResultRow> makeRows(const StudyFigures& figures, ShownAs show);

/// The figures of a study at points, new or saved.
struct PointFigures {
    ElementFigures figures;
    std::uint64_t steps = 0, belowHorizon = 0;
    double seconds = 0;
    StatedPeriod period;
    std::string error;  ///< against rays, in words; empty: not measured
    bool byRays = false;
    std::string engine;  ///< in words, with what "auto" chose it for
    std::vector<ShadedElementFigures> withTrees{};
};
std::vector<ResultRow> makeRows(const PointFigures& figures, ShownAs show);

/// The rows of a comparison: areas with more and with less shadow for each threshold, means, largest changes,
/// cells that stopped or started being receivers, and the contribution of each new building.
std::vector<ResultRow> makeRows(const ComparisonFigures& figures, ShownAs show);

/// "1,234 m² more" and "56 m² less" on a line each, of shadow or of sun, or "no change".
QString describeChangedArea(const ChangeFigures& figures, ShownAs show = ShownAs::shadow);

/// The rows of a score: the total, each month and each interval with sunlit time.
std::vector<ResultRow> makeScoreRows(const Score& score, const std::string& scenario,
                                     const std::string& weights, const StatedPeriod& period, ShownAs show);

/// The sun of places, new or saved.
struct PlaceFigures {
    const SunOfCities& sun;
    std::uint64_t steps = 0, belowHorizon = 0;
    double seconds = 0;
    StatedPeriod period;
    std::string error;  ///< of cells, in words, where `sun` has no errors; empty: not measured
    std::string engine;
};
/// How many places were measured, the sunniest and the darkest of them, and how.
std::vector<ResultRow> makeRows(const PlaceFigures& figures, ShownAs show);

/// One of its places: its sun, what is remarked about it, and the buildings that take most from it, where
/// that is known: null is not.
std::vector<ResultRow> makePlaceRows(const SunOfCities& sun, std::size_t place, ShownAs show,
                                     const ContributionTable* contributions);

/// "Jan 2026"
QString describeMonth(std::chrono::year_month month);

}  // namespace noonmark
