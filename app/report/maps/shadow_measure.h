#pragma once

#include <QString>
#include <vector>

#include "core/engines/api/shadow_field.h"

namespace noonmark {

/// Which of a field's two bands is shown.
enum class ShadowMeasure { gross, continuous };

/// The band, minutes, in grid order; NaN where there is no receiver. Belongs to `field`.
const std::vector<float>& getValues(const ShadowField& field, ShadowMeasure measure);

QString nameOf(ShadowMeasure measure);  ///< "Gross shadow"
QString describeMeasure(
    ShadowMeasure measure);  ///< "minutes in shadow a day": what is measured, with its unit

/// True for a field of one moment: its values say in the sun (0) or in shadow (1), not minutes.
bool isInstant(const ShadowField& field);

/// The upper end of the colours, minutes: the sunlit minutes of a day, or what the band reaches where that is
/// more (a long day of many). Both bands of a field have the same top unless one exceeds it, so that two maps
/// can be compared.
double topOf(const ShadowField& field, ShadowMeasure measure);

}  // namespace noonmark
