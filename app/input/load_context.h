#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/io/context/read_context.h"

namespace noonmark {

/// What those files of a city that are maps (OpenStreetMap's) draw for orientation. Nothing from samples and
/// other formats. Error: a file cannot be read; cancelled().
Result<ContextRead> loadCityContext(const std::vector<std::string>& files, const Frame& frame,
                                    Progress& progress, const std::stop_token& stop);

/// Joins what another file draws to a city's context, which may be null.
std::shared_ptr<const MapContext> joinContext(const std::shared_ptr<const MapContext>& before,
                                              MapContext added);

}  // namespace noonmark
