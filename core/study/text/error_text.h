#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/study/study.h"

namespace noonmark {

/// A row of a table: a name, and a value with its unit.
struct ErrorLine {
    std::string name;
    std::string value;
};

/// The study's error against the ray reference, for display: the error of the area, of the cells, and the
/// sample; or one row that says why there is none.
std::vector<ErrorLine> makeErrorLines(const Study& study);

/// Why a study has no measured error, as a sentence; empty if it has one.
std::string whyNoError(const Study& study);

/// `error` of study.json: always the same keys, null if nothing was measured; `why_not` says why.
nlohmann::ordered_json errorJson(const Study& study);

/// The error alone, with positions in the frame's local metres and in degrees.
nlohmann::ordered_json errorJson(const SampledError& error, const Frame& frame);

/// Groups of warnings: [{"kind", "what", "count", "where": [every location]}].
nlohmann::ordered_json warningsJson(const Warnings& warnings);

/// Indented JSON. Names from files may contain bytes that are not UTF-8: these become U+FFFD.
std::string toJsonText(const nlohmann::ordered_json& json);

}  // namespace noonmark
