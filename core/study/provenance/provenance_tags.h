#pragma once

#include "core/io/files/file_tags.h"
#include "core/study/provenance/provenance.h"

namespace noonmark {

/// What a result was made from, for files that cannot hold JSON: version, project, scenario, baseline, edits,
/// input files with their SHA-256, and attribution. Unknown values are left out.
FileTags makeProvenanceTags(const Provenance& provenance);

}  // namespace noonmark
