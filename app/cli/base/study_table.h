#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include "core/study/study.h"

namespace noonmark::cli {

/// Prints a study as text: figures, cost, files written and warnings.
void printStudy(const Study& study, const std::vector<std::filesystem::path>& files, std::ostream& out);

}  // namespace noonmark::cli
