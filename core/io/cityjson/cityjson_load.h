#pragma once

#include <filesystem>
#include <stop_token>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/cityjson/cityjson_model.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

/// Reads CityJSON 1.0, 1.1, 2.0 or CityJSONSeq into plain values. The whole file is held in memory while it
/// is parsed (about ten times its size), a sequence one line at a time. Error: not JSON, not CityJSON, or
/// empty; a feature that cannot be read gives a warning.
Result<CityJsonData> loadCityJson(const std::filesystem::path& file, const ReadSettings& settings,
                                  Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
