#pragma once

#include "app/report/sheets/answer_source.h"
#include "app/report/sheets/sheet.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// The page of a score: its map, figures by month, the weight table, method, inputs and warnings. All
/// arguments must outlive it.
Sheet makeSheet(const ScoreAnswer& answer, const AnswerSource& source, const LegendChoice& legend = {});

/// Map and figures of that page. All arguments must outlive the map.
SheetMap makeScoreMap(const Score& score, const City& city, const Region& region,
                      const LegendChoice& choice = {});
std::vector<FigureText> makeScoreFigures(const Score& score);

}  // namespace noonmark
