#pragma once

#include <nlohmann/json.hpp>

#include "core/city/footprint.h"

namespace noonmark {

/// A ring as [[x, y], ...], local metres; it comes back to the last bit.
nlohmann::ordered_json ringJson(const Ring& ring);

/// Throws nlohmann's exceptions, or std::invalid_argument for fewer than three points.
Ring ringOf(const nlohmann::ordered_json& json);

}  // namespace noonmark
