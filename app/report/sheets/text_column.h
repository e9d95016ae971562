#pragma once

#include <QRectF>
#include <QString>
#include <vector>

#include "app/report/maps/style.h"

namespace noonmark {

enum class TextKind {
    heading,
    body,
    code,  ///< monospaced, for text to copy: hashes, command lines
};

/// A paragraph of a column.
struct TextBlock {
    TextKind kind = TextKind::body;
    QString text;
};
using TextBlocks = std::vector<TextBlock>;

TextBlock heading(const QString& text);
TextBlock body(QString text);  ///< numbers and units stay together: "10 min" is never broken

/// Height of the blocks in a column of `width`, with body text of `points`. Lines break between words, or
/// inside a word that is longer than a line, so nothing exceeds the column.
double heightOf(const Canvas& canvas, const TextBlocks& blocks, double width, double points);

/// The largest body size from `maximum` down to `minimum` points, in steps of 0.2, at which the blocks fit
/// into `size`; `minimum` if none does.
double fittingPoints(const Canvas& canvas, const TextBlocks& blocks, const QSizeF& size, double maximum,
                     double minimum);

/// Paints the blocks from the top of `area`. Lines that would pass its lower edge are dropped, and the last
/// line states that the JSON file contains the rest. Returns the y below the last line.
double paintBlocks(const Canvas& canvas, const TextBlocks& blocks, const QRectF& area, double points);

}  // namespace noonmark
