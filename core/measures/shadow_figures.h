#pragma once

#include "core/describe/answer_page.h"
#include "core/describe/figure.h"
#include "core/engines/api/tree_shade.h"
#include "core/measures/statistics.h"

namespace noonmark {

const Figures<ShadowStatistics>& shadowFigures();

/// The results among them of a field with trees (TreeColumns::evergreen or seasonal), with keys, labels and
/// definitions of their own: "mean_gross_min_evergreen". They take ShadowStatistics.
std::span<const Figure> treeFigures(TreeColumns column);

/// What a field says: hours of sun a day and the share in shade, the darkest spot, how the area divides into
/// hours of sun. `where`: the name of the region; empty: it has none. O(cells).
AnswerPage makePage(const ShadowField& field, const ShadowStatistics& statistics, const std::string& where,
                    ShownAs show = ShownAs::shadow);

}  // namespace noonmark
