#pragma once

#include <QString>
#include <vector>

#include "core/measures/shadow_figures.h"

namespace noonmark {

/// Which band of a field is shown.
enum class ShadowMeasure { gross, continuous };

/// The band in minutes, grid order; NaN where there is no receiver. A member of `field`.
const std::vector<float>& getValues(const ShadowField& field, ShadowMeasure measure);

QString nameOf(ShadowMeasure measure);           ///< "Gross shadow"
QString describeMeasure(ShadowMeasure measure);  ///< "minutes in shadow a day": measure and unit

/// Upper end of the colour scale, minutes: the sunlit minutes of a day, or the band's maximum where that is
/// larger (on a day longer than the mean). Both bands of a field have the same top unless one exceeds it, so
/// that two maps can be compared.
double topOf(const ShadowField& field, ShadowMeasure measure);

}  // namespace noonmark
