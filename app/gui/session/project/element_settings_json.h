#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "core/study/elements/place_elements.h"

namespace noonmark {

/// Where the points of a study, or the windows of a review, lie; as the project's view state holds it.
nlohmann::ordered_json elementSettingsJson(const ElementSettings& elements);
/// None for JSON of another structure, and where a length is out of its range.
std::optional<ElementSettings> elementSettingsFrom(const nlohmann::ordered_json& json);

}  // namespace noonmark
