#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/describe/answer_page.h"
#include "core/describe/figure.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/api/tree_shade.h"
#include "core/measures/error_sample.h"
#include "core/measures/statistics.h"

namespace noonmark {

// Whether the longest runs were counted (core/engines/api/shadow_field.h). If not, minutes of continuous
// shadow are NaN in every cell and every statistic, and nothing is displayed or written for them.

/// Takes a map of continuous minutes, or of their change. Reads as far as the first number; reads all cells
/// if there is none.
inline bool hasRuns(std::span<const float> continuousMin) {
    return std::ranges::any_of(continuousMin, [](float minutes) { return !std::isnan(minutes); });
}
inline bool hasRuns(const ShadowField& field) { return hasRuns(field.continuousMin); }

/// Whether it is the field of one moment, which holds 0 (sunlit) or 1 (in shadow) instead of minutes.
inline bool isInstant(const ShadowField& field) {
    return field.days == 1 && field.stepMinutes == 1 && field.sunlitMinutesPerDay <= 1;
}

inline bool hasRuns(const ShadowStatistics& figures) { return !std::isnan(figures.meanContinuousMin); }
inline bool hasRuns(const SampledError& error) { return !std::isnan(error.continuous.meanMin); }

const Figures<ShadowStatistics>& shadowFigures();

/// "without trees", "trees as evergreens", "trees with their seasons".
std::string_view describeTrees(TreeColumns column);

/// The results among figures where trees of one column are measured, with keys, labels and definitions of
/// their own: "hours_mean_evergreen".
class FiguresWithTrees {
public:
    FiguresWithTrees(std::span<const Figure> figures, TreeColumns column);
    [[nodiscard]] std::span<const Figure> rows() const { return rows_; }

private:
    std::string_view hold(std::string text) { return texts_.emplace_back(std::move(text)); }
    std::deque<std::string> texts_;  // that the facts refer to
    std::vector<Figure> rows_;
};

/// The results among them of a field with trees (TreeColumns::evergreen or seasonal), with keys, labels and
/// definitions of their own: "mean_gross_min_evergreen". They take ShadowStatistics.
std::span<const Figure> treeFigures(TreeColumns column);

/// What a field says: hours of sun a day and the share in shade, the darkest spot, how the area divides into
/// hours of sun. `where`: the name of the region; empty: it has none. O(cells).
AnswerPage makePage(const ShadowField& field, const ShadowStatistics& statistics, const std::string& where,
                    ShownAs show = ShownAs::shadow);

}  // namespace noonmark
