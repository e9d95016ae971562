#pragma once

#include <QColor>

#include "core/review/criteria/verdict.h"

namespace noonmark {

/// The mark of a verdict in tables of printed reviews, told apart by colour-blind readers; the window's text
/// colours, which must contrast with its background, are verdictColour().
QColor verdictMark(Verdict verdict);

}  // namespace noonmark
