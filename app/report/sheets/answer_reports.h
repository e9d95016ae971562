#pragma once

#include "app/report/maps/answer_legends.h"
#include "app/report/sheets/sheet.h"
#include "core/city/city.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// The city that the files of a comparison or a score need besides the answer. `city` must outlive this
/// object.
struct AnswerSource {
    const City& city;  ///< in a comparison: the city after the change
};

/// The page of a comparison: maps of the change of gross and, where computed, continuous shadow on one scale,
/// figures per threshold, method, inputs and warnings. All arguments must outlive it.
Sheet makeSheet(const ImpactAnswer& answer, const AnswerSource& source, const ChangeScale& scale,
                const LegendChoice& legend = {});

/// The options of the command that draws such a page.
std::vector<CommandOption> drawnOptions(const ChangeScale& scale, const LegendChoice& legend);

/// The map of that page. `city` after the change; `impact`: the total. All arguments must outlive the map.
SheetMap makeImpactMap(const Impact& impact, const City& city, const Region& region, ShadowMeasure measure,
                       const ChangeScale& scale, const LegendChoice& choice = {});

/// The page of a score: its map, figures by month, the weight table, method, inputs and warnings. All
/// arguments must outlive it.
Sheet makeSheet(const ScoreAnswer& answer, const AnswerSource& source, const LegendChoice& legend = {});

/// Map and figures of that page. All arguments must outlive the map.
SheetMap makeScoreMap(const Score& score, const City& city, const Region& region,
                      const LegendChoice& choice = {});
std::vector<FigureText> makeScoreFigures(const Score& score);

}  // namespace noonmark
