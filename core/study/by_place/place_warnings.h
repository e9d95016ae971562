#pragma once

#include "core/study/by_place/cell_groups.h"

namespace noonmark {

/// Warns in the first city's answer of its trees, of places without figures, beyond its terrain and on its
/// water; states in all why places have none. `all`: the cells of all places. Error: cancelled().
Result<void> warnOfPlaces(std::span<const City* const> cities, std::vector<SunByPlace>& made,
                          const CellGroup& all, const std::stop_token& stop);

}  // namespace noonmark
