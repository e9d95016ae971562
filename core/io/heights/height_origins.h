#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/io/heights/field_roles.h"
#include "core/io/heights/unknown_fields.h"

namespace noonmark {

/// Number of features by HeightReading::origin; "" is the default height.
using HeightOrigins = std::map<std::string, std::size_t>;

/// Adds the fields that the heights of `file` came from. If more than a tenth of its features have none, adds
/// the unknown fields that could hold them; warns if no field of heights or storeys is known.
void addHeightFacts(const HeightOrigins& origins, const std::vector<KnownField>& fields,
                    const UnknownFields& unknown, const std::string& file, HeightFacts& facts,
                    Warnings& warnings);

}  // namespace noonmark
