#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/study/study.h"

namespace noonmark {

/// What a computation was asked: period, region, cells, engine and its settings, the program. Keys as in
/// study.json.
nlohmann::ordered_json settingsJson(const StudySettings& settings);

/// A field of a CSV file (RFC 4180).
std::string csvField(const std::string& text);

}  // namespace noonmark
