#include "core/city/city_observer.h"

#include <glm/geometric.hpp>

#include "core/geo/earth_drop.h"

namespace noonmark {

Observer placeObserver(const City& city, glm::dvec2 local) {
    Observer observer{city.frame.lonLatFromLocal(local), city.frame.originElevationM()};
    const glm::dmat2 level = city.frame.localFromEastNorth(observer.place);
    const glm::dvec2 slope = city.terrain ? earthDropSlope(local) : glm::dvec2(0);
    // Columns are the images of east, north and up.
    observer.frameFromPlace = {glm::dvec3(level[0], -glm::dot(slope, level[0])),
                               glm::dvec3(level[1], -glm::dot(slope, level[1])), glm::dvec3(0, 0, 1)};
    return observer;
}

double computeVerticalErrorDeg(double distanceM) {
    return Radians{distanceM / meanEarthRadiusM}.degrees().value;
}

}  // namespace noonmark
