#pragma once

#include <QRectF>
#include <QString>
#include <vector>

#include "app/report/sheets/style.h"

namespace noonmark {

enum class TextKind {
    heading,
    body,
    code,  ///< equally wide letters, for what is copied: hashes, command lines
};

/// A paragraph of a column.
struct TextBlock {
    TextKind kind = TextKind::body;
    QString text;
};
using TextBlocks = std::vector<TextBlock>;

TextBlock heading(const QString& text);
TextBlock body(QString text);  ///< numbers keep to their units: "10 min" is never broken

/// How high the blocks are in a column `width` wide, with body text of `points`. Lines break between words,
/// and inside a word that is longer than a line: nothing is wider than the column.
double heightOf(const Canvas& canvas, const TextBlocks& blocks, double width, double points);

/// The largest body size from `most` down to `least` points, in steps of 0.2, at which the blocks fit `size`;
/// `least` if none does.
double fittingPoints(const Canvas& canvas, const TextBlocks& blocks, const QSizeF& size, double most,
                     double least);

/// Paints the blocks from the top of `area`; lines that would pass its lower edge are left away and the last
/// one that fits says that the rest is in study.json. Returns the y below the last line.
double paintBlocks(const Canvas& canvas, const TextBlocks& blocks, const QRectF& area, double points);

}  // namespace noonmark
