#pragma once

#include <filesystem>
#include <vector>

#include "core/receivers/points/point_list.h"

namespace noonmark {

/// Reads a CSV file of points (parsePointList()). Error: it cannot be read, is larger than 16 MB, or what
/// parsePointList() refuses.
Result<std::vector<ListedPoint>> readPointFile(const std::filesystem::path& file);

}  // namespace noonmark
