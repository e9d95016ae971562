#pragma once

#include <nlohmann/json.hpp>

#include "core/city/footprints/footprint.h"
#include "scenarios/project/tables/checked_row.h"

namespace noonmark {

/// A ring as [[x, y], ...] in local metres; it round-trips exactly.
nlohmann::ordered_json ringJson(const Ring& ring);

/// Throws nlohmann's exceptions, or std::invalid_argument for fewer than three points.
Ring parseRing(const nlohmann::ordered_json& json);

/// Throws nlohmann's exceptions where the value is not a number, std::invalid_argument where it is out of
/// range.
double numberFrom(const nlohmann::ordered_json& json, const NumberLimits& limits);

}  // namespace noonmark
