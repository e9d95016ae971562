#pragma once

#include <cstddef>
#include <numeric>

namespace noonmark {

/// k x stride modulo `count`, k = 0, 1, 2, ..., is every number below `count` once, each far from the one
/// before: near the golden section of all, and without a common divisor. 1 for counts up to 2.
constexpr std::size_t chooseScatteringStride(std::size_t count) {
    std::size_t stride = count * 618 / 1000;
    if (stride == 0) stride = 1;
    while (std::gcd(stride, count) > 1) ++stride;
    return stride;
}

}  // namespace noonmark
