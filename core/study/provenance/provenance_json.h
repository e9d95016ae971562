#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/base/result.h"
#include "core/study/provenance/provenance.h"

namespace noonmark {

/// Adds what a result was made from: `project` (file, hashes; null: none), `scenario`, `scenario_edits`,
/// `scenario_city_sha256`, for a comparison the same of `baseline`; `inputs`, `read_settings` (what differs
/// from the defaults; null: not known) and `attribution`.
void addProvenance(nlohmann::ordered_json& json, const Provenance& provenance);

/// Adds `repeat`, the command line; if there is none it is null and `repeat_note` says why.
void addRepeat(nlohmann::ordered_json& json, const Result<std::string>& command);

}  // namespace noonmark
