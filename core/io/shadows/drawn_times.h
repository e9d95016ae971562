#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/io/shadows/shadow_drawing.h"

namespace noonmark {

/// Which times to draw: of each day those named, or all of them while the sun is up.
struct DrawnTimeChoice {
    std::vector<std::string> days;   ///< "2026-03-21"
    std::vector<std::string> times;  ///< wall clock: "09:00"
    int everyMin = 0;                ///< from midnight on; 0: only the times
    std::string zone;                ///< "Europe/Monaco"
};

/// The times with the sun up, in order. A time that was asked for by name and has no sun gives a warning.
/// Error: no time, a date, a time or a zone that cannot be read, or no time with the sun up.
Result<std::vector<DrawnTime>> listDrawnTimes(const DrawnTimeChoice& choice, const City& city,
                                              Warnings& warnings);

/// Every day of a year, for DrawnTimeChoice::days.
std::vector<std::string> listDaysOf(int year);

}  // namespace noonmark
