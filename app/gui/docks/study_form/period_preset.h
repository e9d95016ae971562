#pragma once

#include <QString>
#include <array>

#include "core/sun/period.h"

namespace noonmark {

/// Days that planners ask for most.
enum class PeriodPreset { today, march, june, december, growingSeason, year, own };

/// In the order of the list; `own` is the last.
inline constexpr std::array allPeriodPresets{
    PeriodPreset::today,         PeriodPreset::march, PeriodPreset::june, PeriodPreset::december,
    PeriodPreset::growingSeason, PeriodPreset::year,  PeriodPreset::own};

/// "21 March"; the growing season with its months, which depend on the hemisphere.
QString nameOf(PeriodPreset preset, double latitudeDeg);

/// `period` with the days of the preset, in the year of the period; hours and all else stay. The growing
/// season is April to October, south of the equator October to April. `own` changes nothing.
Period applied(PeriodPreset preset, Period period, CivilDate today, double latitudeDeg);

/// The preset whose days the period has; the first of several, `own` if none.
PeriodPreset presetOf(const Period& period, CivilDate today, double latitudeDeg);

}  // namespace noonmark
