#pragma once

#include <QString>

namespace noonmark {

/// The modes of the window: the two of the paper (section 6), and the rules.
enum class ViewMode {
    exploration,  ///< Now: shadow on every visible surface, computed again for each view
    analysis,     ///< Study: the ground of the region, with figures, by the engine of the study
    review,       ///< the same map, with rules and verdicts beside it
};

QString nameOf(ViewMode mode);           ///< "Now", "Study", "Review"
QString describeMeasure(ViewMode mode);  ///< for a tooltip

}  // namespace noonmark
