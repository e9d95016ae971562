#pragma once

#include <memory>

#include "app/gui/base/layers/tile_view.h"
#include "app/questions/window_question.h"

namespace noonmark {

/// Which verdicts on windows the view shows.
enum class ShownVerdicts { after, before, change, none };

/// From the former verdict to the later one.
enum class VerdictChange { same, worse, better, notCompared };
VerdictChange findChange(const WindowReview& review);

/// Colours of tiles: each two can be told apart with normal and with colour-blind eyes.
QColor tileColour(Verdict verdict);
QColor tileColour(VerdictChange change);

/// "floor 3, before: pass, after: fail", with the window's id in front.
QString describeVerdicts(const WindowReview& review);

/// A tile for each pane of the answer, in the order of WindowStudy::panes, with its legend; null: `shown` is
/// none. Some 0.2 us a pane.
std::shared_ptr<const TileView> makeVerdictTiles(const std::shared_ptr<const WindowAnswer>& answer,
                                                 ShownVerdicts shown);

}  // namespace noonmark
