#pragma once

#include <memory>

#include "app/gui/base/layers/tile_view.h"
#include "app/questions/glazing_question.h"

namespace noonmark {

/// Which verdicts on windows the view shows.
enum class ShownVerdicts { after, before, change, none };

/// From the former verdict to the later one.
enum class VerdictChange { same, worse, better, notCompared };
VerdictChange findChange(const GlazingReview& review);

/// Colours of tiles: each two can be told apart with normal and with colour-blind eyes.
QColor tileColour(Verdict verdict);
QColor tileColour(VerdictChange change);

/// "floor 3, before: pass, after: fail", with the window's id in front.
QString describeVerdicts(const GlazingReview& review);

/// A tile for each pane of the answer, in the order of GlazingStudy::panes, with its legend; null: `shown` is
/// none. Some 0.2 us a pane.
std::shared_ptr<const TileView> makeVerdictTiles(const std::shared_ptr<const GlazingAnswer>& answer,
                                                 ShownVerdicts shown);

}  // namespace noonmark
