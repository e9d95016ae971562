#pragma once

#include <cstddef>
#include <numeric>

namespace noonmark {

/// A stride such that k x stride modulo `count`, for k = 0, 1, 2, ..., visits every number below `count`
/// once, with consecutive numbers far apart: near the golden section of `count` and coprime to it. 1 for
/// counts up to 2.
constexpr std::size_t chooseScatteringStride(std::size_t count) {
    std::size_t stride = count * 618 / 1000;
    if (stride == 0) stride = 1;
    while (std::gcd(stride, count) > 1) ++stride;
    return stride;
}

}  // namespace noonmark
