#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "core/study/provenance/provenance.h"

namespace noonmark {

/// A list of {path, bytes, sha256}; bytes and sha256 are null for samples, which are generated.
nlohmann::ordered_json inputsJson(const std::vector<InputFile>& inputs);

}  // namespace noonmark
