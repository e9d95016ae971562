#include "app/window/change_scale.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

ChangeScale changeScaleOf(const std::vector<float>& values, float least) {
    std::vector<float> amounts;
    for (const float value : values)
        if (std::abs(value) > least) amounts.push_back(std::abs(value));  // NaN is not above anything
    if (amounts.empty()) return {};
    std::ranges::sort(amounts);
    return {double(amounts[(amounts.size() - 1) * 98 / 100]), double(amounts.back())};
}

}  // namespace noonmark
