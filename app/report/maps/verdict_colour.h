#pragma once

#include <QColor>

#include "core/review/criteria/verdict.h"

namespace noonmark {

/// The colour of a verdict on maps, tiles and sheets, in the view and on paper: each two can be told apart
/// with normal and with colour-blind eyes. The window's text colours, which must contrast with its
/// background, are verdictColour().
QColor verdictMark(Verdict verdict);

}  // namespace noonmark
