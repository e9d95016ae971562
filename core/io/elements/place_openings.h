#pragma once

#include <string>
#include <vector>

#include "core/io/cityjson/file_opening.h"
#include "core/io/elements/read_glazing.h"

namespace noonmark {

/// Adds the openings of a city model to `read`, in the frame of the city; those too far away give a warning.
/// `crs`: of the file; empty: that of the settings. `file`: for messages. Error: there are none or too many,
/// no reference system is known, or all are too far away.
Result<void> placeOpenings(const std::vector<FileOpening>& openings, const std::string& crs,
                           const std::string& file, const GlazingFileSettings& settings, const City& city,
                           GlazingRead& read);

}  // namespace noonmark
