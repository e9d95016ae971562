#pragma once

#include "app/report/sheets/sheet.h"
#include "core/study/study.h"

namespace noonmark {

/// The page of a study: maps, figures, method, error, inputs with their hashes, warnings, and the repeat
/// command. `study` must outlive it.
Sheet makeSheet(const Study& study, const LegendChoice& legend = {});

/// Writes the report of a study as a PDF of one A4 page. Text remains text. `device` must be open; the caller
/// checks it for write errors. False if the PDF could not be started.
bool writeReport(const Study& study, QIODevice& device, const LegendChoice& legend = {});

/// The map of one measure as a picture, so many pixels wide: see makePicture().
QImage mapPicture(const Study& study, ShadowMeasure measure, int width = pictureWidth,
                  const LegendChoice& legend = {});

}  // namespace noonmark
