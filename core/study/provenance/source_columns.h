#pragma once

#include <string>

#include "core/study/provenance/provenance.h"

namespace noonmark {

/// The last columns of a table: project, scenario, baseline, content_sha256; so that a table that is copied
/// alone still says what it is of. The values of a line likewise; both begin with a comma.
inline constexpr const char* sourceColumns = ",project,scenario,baseline,content_sha256";
std::string sourceFields(const Provenance& provenance);

/// A field of a CSV file (RFC 4180).
std::string csvField(const std::string& text);

}  // namespace noonmark
