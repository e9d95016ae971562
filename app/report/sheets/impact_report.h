#pragma once

#include "app/report/maps/impact_legend.h"
#include "app/report/sheets/answer_source.h"
#include "app/report/sheets/sheet.h"
#include "scenarios/impact/impact_text.h"

namespace noonmark {

/// The page of a comparison: maps of the change of gross and, where computed, continuous shadow on one scale,
/// figures per threshold, method, inputs and warnings. All arguments must outlive it.
Sheet makeSheet(const ImpactAnswer& answer, const AnswerSource& source, const ChangeScale& scale,
                const LegendChoice& legend = {});

/// The options of the command that draws such a page.
std::vector<CommandOption> drawnOptions(const ChangeScale& scale, const LegendChoice& legend);

/// The map of that page. `city` after the change; `impact`: the total. All arguments must outlive the map.
SheetMap makeImpactMap(const Impact& impact, const City& city, const Region& region, ShadowMeasure measure,
                       const ChangeScale& scale, const LegendChoice& choice = {});

}  // namespace noonmark
