#include "core/city/city.h"

namespace noonmark {

Box2 bounds(const City& city) {
    Box2 box;
    for (const auto& building : city.buildings) box.add(bounds(*building));
    return box;
}

float groundAt(const City& city, glm::dvec2 point) {
    return city.terrain ? elevationAt(*city.terrain, point) : 0.0F;
}

}  // namespace noonmark
