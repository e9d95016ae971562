#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/io/heights/height_facts.h"

namespace noonmark {

/// {fields: [{file, field, meaning, unit, features}], could_be: [{file, field, low, high, whole, features}],
/// bases: [{file, buildings, gap_m, spread_m, rule, aloft, apart, text}]}
nlohmann::ordered_json heightFactsJson(const HeightFacts& facts);

/// Parses such JSON; nothing if it has another structure or a wrong number.
std::optional<HeightFacts> parseHeightFacts(const std::string& text);

}  // namespace noonmark
