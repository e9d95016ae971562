#include "core/city/main_bounds.h"

#include <algorithm>
#include <vector>

namespace noonmark {

namespace {

struct Span {
    float low, high;
    [[nodiscard]] bool has(float value) const { return value >= low && value <= high; }
};

// What the nine tenths in the middle span, with the same width on either side; at least 100 m.
Span mainSpan(std::vector<float> values) {
    constexpr float minM = 100;
    const auto at = [&](std::size_t twentieths) {
        const auto place = values.begin() + std::ptrdiff_t(twentieths * (values.size() - 1) / 20);
        std::ranges::nth_element(values, place);
        return *place;
    };
    const float low = at(1), high = at(19);
    const float width = std::max(high - low, minM);
    return {low - width, high + width};
}

}  // namespace

Box2 mainBounds(const City& city) {
    if (city.buildings.empty()) return {};
    std::vector<Box2> boxes;
    std::vector<float> x, y;
    for (const auto& building : city.buildings) {
        boxes.push_back(bounds(*building));
        x.push_back((boxes.back().low.x + boxes.back().high.x) / 2);
        y.push_back((boxes.back().low.y + boxes.back().high.y) / 2);
    }
    const Span columns = mainSpan(x), rows = mainSpan(y);
    Box2 box;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (columns.has(x[i]) && rows.has(y[i])) box.add(boxes[i]);
    return box.empty() ? bounds(city) : box;
}

}  // namespace noonmark
