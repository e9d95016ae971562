#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include "core/study/study.h"

namespace noonmark::cli {

/// A study for people: its figures, what it cost, the files that it left and the warnings.
void printStudy(const Study& study, const std::vector<std::filesystem::path>& files, std::ostream& out);

}  // namespace noonmark::cli
