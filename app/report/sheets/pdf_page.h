#pragma once

#include <QString>

#include "app/report/maps/style.h"
#include "app/report/sheets/sheet.h"

class QPdfWriter;

namespace noonmark {

/// The A4 page of all PDFs, in points from the top left corner.
constexpr double pageWidthPt = 595.28;
constexpr double pageHeightPt = 841.89;
constexpr double sidePt = 40;
constexpr double topPt = 36;
constexpr double contentPt = pageWidthPt - 2 * sidePt;

/// Sets page size, resolution, title and creator; call it before painting. The PDF page has no margins: the
/// painter leaves them free.
void beginPdf(QPdfWriter& writer, const QString& title);

/// Attaches a record, if there is one. Call it before painting.
void attachRecord(const SheetRecord& record, QPdfWriter& writer);

/// The canvas of such a page.
Canvas pdfCanvas(QPainter& painter);

}  // namespace noonmark
