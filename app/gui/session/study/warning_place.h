#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/city/city.h"

namespace noonmark {

/// The building that a warning's place names: "way 264768896", "midtown.osm.pbf: relation 12, height". Its
/// id, or that of one of its parts, must occur as a whole word; if several do, the longest counts. Nothing if
/// none does. O(buildings).
std::optional<std::uint32_t> buildingNamed(const City& city, const std::string& where);

}  // namespace noonmark
