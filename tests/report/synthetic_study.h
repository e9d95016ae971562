#pragma once

#include "core/study/study.h"

namespace noonmark::tests {

/// A synthetic study, 120 m x 80 m at 1 m, with a different value in each quarter (asymmetric in both
/// directions) and one building:
///
///     north-west 60 min | north-east 360 min
///     ------------------+-------------------     360 sunlit minutes a day
///     south-west  0 min | south-east 180 min
///
/// The building covers x 50 to 70, y 30 to 50; its northern neighbour is an overhang over x 50 to 70, y 50 to
/// 60. Continuous shadow is half of gross shadow.
Study syntheticStudy();

/// The same study without continuous shadow.
Study grossOnly(Study study);

}  // namespace noonmark::tests
