#pragma once

#include "core/study/study.h"

namespace noonmark::tests {

/// A study made by hand, 120 m x 80 m at 1 m, with a different value in each quarter (asymmetric both ways)
/// and one building:
///
///     north-west 60 min | north-east 360 min
///     ------------------+-------------------     360 sunlit minutes a day
///     south-west  0 min | south-east 180 min
///
/// The building covers x 50 to 70, y 30 to 50, its northern neighbour hangs over x 50 to 70, y 50 to 60.
/// Continuous is half of gross.
Study syntheticStudy();

/// The same without its longest runs.
Study grossOnly(Study study);

}  // namespace noonmark::tests
