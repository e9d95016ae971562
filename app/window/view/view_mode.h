#pragma once

#include <QString>

namespace noonmark {

/// What the window computes and shows (paper, section 6, and the ray reference as a third).
enum class ViewMode {
    exploration,   ///< shadow on every surface that the view shows, anew with each view
    analysis,      ///< the ground of the region, with figures, by the engine of the study
    rayReference,  ///< the same by the ray reference
};

QString nameOf(ViewMode mode);           ///< "Exploration"
QString describeMeasure(ViewMode mode);  ///< for a tooltip

}  // namespace noonmark
