#pragma once

#include <vector>

namespace noonmark {

/// How large values around zero are, without their signs.
struct ChangeScale {
    double usual = 0;  ///< 98 % of those that are not zero are no larger
    double most = 0;
};

/// Values up to `least` count as zero, and so does NaN. O(n log n).
ChangeScale changeScaleOf(const std::vector<float>& values, float least);

}  // namespace noonmark
