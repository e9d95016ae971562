#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/io/heights/height_facts.h"

namespace noonmark {

/// {fields: [{file, field, meaning, unit, features}], could_be: [{file, field, low, high, whole, features}]}
nlohmann::ordered_json heightFactsJson(const HeightFacts& facts);

/// The same read back from a text; nothing where it is of another shape, or a number in it is none.
std::optional<HeightFacts> parseHeightFacts(const std::string& text);

}  // namespace noonmark
