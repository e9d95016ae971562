#pragma once

#include <QString>

#include "app/gui/tools/live/live_change.h"

namespace noonmark {

/// What an edit changes, a few lines for beside the cursor: area of new shadow over the thresholds, minutes
/// at the worst spot, the places with most new shadow, and `verdicts` (empty: none) in the last line.
QString describeEffect(const LiveChange& change, const QString& verdicts);

}  // namespace noonmark
