#pragma once

#include <string>

#include "scenarios/massing/massing.h"

namespace noonmark::cli {

/// "87 storeys, 304.5 m; gross floor area 87,696 m2, ratio 25.5, coverage 29 %"
std::string lineOf(const MassingFigures& figures);

/// "  offices: 10 storeys, 5,000 m2", a line for each use; empty where none is stated.
std::string linesOf(const std::vector<UseArea>& uses);

}  // namespace noonmark::cli
