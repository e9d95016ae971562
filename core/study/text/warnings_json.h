#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/base/warnings.h"

namespace noonmark {

/// Groups of warnings: [{"kind", "what", "count", "where": [every place]}].
nlohmann::ordered_json warningsJson(const Warnings& warnings);

/// Indented text. Names from files may hold bytes that are no UTF-8: those become U+FFFD.
std::string jsonText(const nlohmann::ordered_json& json);

}  // namespace noonmark
