#pragma once

#include "app/report/book/book.h"
#include "app/report/maps/change_scale.h"
#include "app/report/sheets/answer_reports.h"
#include "app/report/sheets/study_report.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

// Books of results with maps. The arguments must outlive the book, whose maps refer to them.

/// The book of a study of cells: its maps, sun by month where it was measured, method and sources.
Book makeStudyBook(const Study& study, const BookSettings& settings);

/// The book of a comparison: maps of the change, both scenarios side by side on one scale, sole contributions
/// of new buildings where they were measured, method and sources.
Book makeImpactBook(const ImpactAnswer& answer, const AnswerSource& source, const ChangeScale& scale,
                    const BookSettings& settings, const LegendChoice& legend = {});

/// The book of a score: its map, bars of shadow area and score by month, the intervals of the weight table,
/// method and sources.
Book makeScoreBook(const ScoreAnswer& answer, const AnswerSource& source, const BookSettings& settings,
                   const LegendChoice& legend = {});

/// The pages of a saved result of any question: its figures, what they mean, and where they are from.
Book makeSavedBook(const SavedResult& result, const SavedOrigin& origin, const SavedSource& source,
                   const std::vector<FigureLine>& lines, const BookSettings& settings);

}  // namespace noonmark
