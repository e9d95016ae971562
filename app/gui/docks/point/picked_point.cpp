#include "app/gui/docks/point/picked_point.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/city/city_observer.h"

namespace noonmark {

namespace {

constexpr double uprightBelow = 0.5;  // of the normal's vertical component: steeper than 60 degrees
constexpr double offWallM = 0.02;     // so that rounding does not put the point inside the building

}  // namespace

PointQuestion questionAt(const City& city, const Pick& pick) {
    PointQuestion question;
    glm::dvec2 place(pick.position);
    if (pick.building) {
        const glm::dvec3 normal(pick.normal);
        if (std::abs(normal.z) < uprightBelow) {
            place += offWallM * glm::normalize(glm::dvec2(normal));
            const glm::dvec3 facing = glm::transpose(placeObserver(city, place).frameFromPlace) * normal;
            const double azimuthDeg = Radians{std::atan2(facing.x, facing.y)}.degrees().value;
            question.facingDeg = std::fmod(azimuthDeg + 360, 360);
        }
        question.heightM = std::max(0.0, pick.position.z - double(groundAt(city, place)));
    }
    question.at = city.frame.lonLatFromLocal(place);
    return question;
}

}  // namespace noonmark
