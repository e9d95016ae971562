#pragma once

#include <array>
#include <string>

#include "core/study/provenance/provenance.h"

namespace noonmark {

/// The last columns of a table: project, scenario, baseline, content_sha256, so that a copied table still
/// states its origin; and the values of a row. Both begin with a comma.
inline constexpr const char* sourceColumns = ",project,scenario,baseline,content_sha256";
std::string sourceFields(const Provenance& provenance);

/// The same one by one, for tables that are no text.
inline constexpr std::array sourceColumnNames{"project", "scenario", "baseline", "content_sha256"};
using SourceValues = std::array<std::string, sourceColumnNames.size()>;
SourceValues sourceValues(const Provenance& provenance);

}  // namespace noonmark
