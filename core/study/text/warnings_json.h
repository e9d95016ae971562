#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/base/warnings.h"

namespace noonmark {

/// Groups of warnings: [{"kind", "what", "count", "where": [every location]}].
nlohmann::ordered_json warningsJson(const Warnings& warnings);

/// Indented JSON. Names from files may contain bytes that are not UTF-8: these become U+FFFD.
std::string toJsonText(const nlohmann::ordered_json& json);

}  // namespace noonmark
