#pragma once

#include <QString>

#include "app/report/sheets/style.h"

class QPdfWriter;

namespace noonmark {

/// The A4 pages of all PDFs, in points from the top left corner.
constexpr double pageWidthPt = 595.28;
constexpr double pageHeightPt = 841.89;
constexpr double sidePt = 40;
constexpr double topPt = 36;
constexpr double contentPt = pageWidthPt - 2 * sidePt;

/// Sets page, resolution, title and maker, before anything is painted. The page's margins are the painter's.
void beginPdf(QPdfWriter& writer, const QString& title);

/// What paints on such a page.
Canvas pdfCanvas(QPainter& painter);

}  // namespace noonmark
