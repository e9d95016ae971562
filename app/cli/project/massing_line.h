#pragma once

#include <string>

#include "scenarios/massing/massing.h"

namespace noonmark::cli {

/// "87 storeys, 304.5 m; gross floor area 87,696 m2, ratio 25.5, coverage 29 %"
std::string lineOf(const MassingFigures& figures);

}  // namespace noonmark::cli
