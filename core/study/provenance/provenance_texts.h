#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/csv_text.h"
#include "core/base/result.h"
#include "core/io/files/write_text.h"
#include "core/study/provenance/provenance.h"

namespace noonmark {

/// A list of {path, bytes, sha256}; bytes and sha256 are null for samples, which are generated.
nlohmann::ordered_json inputsJson(const std::vector<InputFile>& inputs);

/// Adds what a result was made from: `project` (file, hashes; null: none), `scenario`, `scenario_edits`,
/// `scenario_city_sha256`, for a comparison the same of `baseline`; `inputs`, `read_settings` (what differs
/// from the defaults; null: not known) and `attribution`.
void addProvenance(nlohmann::ordered_json& json, const Provenance& provenance);

/// Adds `repeat`, the command line; if there is none it is null and `repeat_note` says why.
void addRepeat(nlohmann::ordered_json& json, const Result<std::string>& command);

/// What a result was made from, for files that cannot hold JSON: version, project, scenario, baseline, edits,
/// input files with their SHA-256, and attribution. Unknown values are left out.
FileTags makeProvenanceTags(const Provenance& provenance);

/// The last columns of a table, so that a copied table still states its origin; and their values in each row.
inline constexpr std::array sourceColumnNames{"project", "scenario", "baseline", "content_sha256"};
using SourceValues = std::array<std::string, sourceColumnNames.size()>;
SourceValues sourceValues(const Provenance& provenance);

/// The same in tables that are text.
std::vector<std::string> withSourceColumns(std::vector<std::string> columns);
void addSource(CsvText& csv, const SourceValues& source);

}  // namespace noonmark
