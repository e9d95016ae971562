#pragma once

#include <chrono>

#include "core/sun/civil_time.h"

namespace noonmark {

/// The day of a common year, 1 to 365, by which leaf days are counted in leap years, too: 29 February is 60,
/// as 1 March.
inline int dayOfCommonYear(CivilDate date) {
    using namespace std::chrono;
    constexpr year common{2026};
    return int((sys_days(common / date.month() / date.day()) - sys_days(common / January / 1)).count()) + 1;
}

}  // namespace noonmark
