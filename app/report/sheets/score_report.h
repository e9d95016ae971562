#pragma once

#include "app/report/files/answer_source.h"
#include "app/report/sheets/sheet.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// The page of a score: its map, figures by months, the weight table, method, inputs and warnings. All that
/// is given outlives it.
Sheet makeSheet(const ScoreAnswer& answer, const AnswerSource& source);

}  // namespace noonmark
