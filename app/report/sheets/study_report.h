#pragma once

#include "app/report/sheets/sheet.h"
#include "core/study/study.h"

namespace noonmark {

/// The page of a study: maps, numbers, method, error, inputs with their hashes, warnings, and how to repeat
/// it. `study` outlives it.
Sheet makeSheet(const Study& study);

/// The report of a study as a PDF of one A4 page. Text stays text. Writes to `device`, which is open; whether
/// everything arrived is for the caller to ask it. False when no PDF could be begun.
bool writeReport(const Study& study, QIODevice& device);

/// The map of one measure as a picture.
QImage mapPicture(const Study& study, ShadowMeasure measure);

}  // namespace noonmark
