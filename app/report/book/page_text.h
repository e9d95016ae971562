#pragma once

#include <QColor>
#include <QRectF>
#include <QString>
#include <string_view>
#include <vector>

#include "app/report/maps/style.h"
#include "app/report/sheets/text_column.h"

namespace noonmark {

/// Paragraphs in one column (text_column.h) that fit into their area: flow.h makes such columns.
struct PageText {
    TextBlocks blocks;
    double points = 8;
};

/// A table that fits into its area: flow.h makes such tables.
struct PageTable {
    std::vector<QString> titles;
    std::vector<double> widthsPt;            ///< by column, including the gap to the next
    std::vector<std::vector<QString>> rows;  ///< as many texts as titles
    std::vector<QColor> marks{};             ///< by row: a square before the first column; invalid: none
    double points = 8;
};

/// Two lines below a diagram, chart or picture: the first in bold.
struct Caption {
    QString first, second;
};

/// A name from a file as one line of text: control characters become spaces, and marks that turn the
/// direction of all later text are left out.
QString plainText(std::string_view text);
QString plainText(QString text);
/// The name of a scenario; that of the existing city in the language of the sheet.
QString scenarioText(std::string_view name);
/// The same with its lines.
QString plainLines(QString text);

/// The height of a text that is broken into lines of `width` (painter units).
double textHeight(const Canvas& canvas, const QString& text, const QFont& font, double width);
/// Paints the lines from the top of `area`. Returns the y below the last one. Lines break inside a word that
/// is longer than a line, so nothing exceeds the width.
double paintLines(const Canvas& canvas, const QRectF& area, const QString& text, const QFont& font,
                  const QColor& colour, Qt::Alignment alignment = Qt::AlignLeft);

/// Paints a text at the largest size from `maximum` to `minimum` points at which its lines fit into `area`,
/// centred vertically. What does not fit even at `minimum` is cut with an ellipsis.
void paintFitted(const Canvas& canvas, const QRectF& area, const QString& text, double maximum,
                 double minimum, QFont::Weight weight = QFont::Normal, const QColor& colour = ink::text,
                 Qt::Alignment alignment = Qt::AlignLeft);

/// Paints a caption from the top of `area`, captionPt(scale) high.
void paintCaption(const Canvas& canvas, const QRectF& area, const Caption& caption, double scale);
constexpr double captionPt(double scale) { return 25 * scale; }

void paintTable(const Canvas& canvas, const QRectF& area, const PageTable& table);
/// Height of a row of texts, or of the titles, painter units.
double rowHeight(const Canvas& canvas, const PageTable& table, const std::vector<QString>& texts,
                 bool isTitle);

}  // namespace noonmark
