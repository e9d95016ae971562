#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/io/footprints/field_roles.h"
#include "core/io/footprints/unknown_fields.h"

namespace noonmark {

/// HeightReading::origin of a file's features, and how many have it; "" is the default height.
using HeightOrigins = std::map<std::string, std::size_t>;

/// Adds the fields that heights of `file` came from; and, where more than a tenth of its features have none,
/// those that could hold them, with a warning where no field of heights or storeys is known.
void addHeightFacts(const HeightOrigins& origins, const std::vector<KnownField>& fields,
                    const UnknownFields& unknown, const std::string& file, HeightFacts& facts,
                    Warnings& warnings);

}  // namespace noonmark
