#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/csv_text.h"
#include "core/study/provenance/provenance.h"

namespace noonmark {

/// The last columns of a table, so that a copied table still states its origin; and their values in each row.
inline constexpr std::array sourceColumnNames{"project", "scenario", "baseline", "content_sha256"};
using SourceValues = std::array<std::string, sourceColumnNames.size()>;
SourceValues sourceValues(const Provenance& provenance);

/// The same in tables that are text.
std::vector<std::string> withSourceColumns(std::vector<std::string> columns);
void addSource(CsvText& csv, const SourceValues& source);

}  // namespace noonmark
