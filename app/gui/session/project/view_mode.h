#pragma once

#include <QString>

namespace noonmark {

/// The modes of the window (paper, section 6, and the ray reference as a third).
enum class ViewMode {
    exploration,  ///< shadow on every visible surface, computed again for each view
    /// The ground of the region, with figures, by the engine of the study.
    analysis,
    rayReference,  ///< the same by the ray reference
};

QString nameOf(ViewMode mode);           ///< "Exploration"
QString describeMeasure(ViewMode mode);  ///< for a tooltip

}  // namespace noonmark
