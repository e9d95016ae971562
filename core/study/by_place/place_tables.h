#pragma once

#include <span>
#include <string_view>

#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

/// A table of an answer about places, as it is written for spreadsheets. Its columns are the same whatever
/// trees, months and dates the answer has; with scenarios those of the change besides. makeTable() is the
/// other form, with a row for each place, which layers of maps need.
struct PlaceTable {
    const char* file;
    ElementTable (*make)(const SunByPlace& sun, std::span<const ComparedSun> compared);
};

/// places.csv: a row for each place, city and way to count trees, with the figures of the whole period.
/// places_by_time.csv: the same for each season, month and date.
std::span<const PlaceTable> placeTables();

/// "season", "month", "date".
std::string_view nameOf(SunPart::Of of);

}  // namespace noonmark
