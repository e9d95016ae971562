#include <algorithm>
#include <cmath>

#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

ColourScale makeColourScale(const SunByPlace& sun, const LegendChoice& choice) {
    double most = 0;
    for (const SunOfPlace& of : sun.sun) most = std::fmax(most, of.meanHours);
    return makeThresholdScale(choice, sun.settings.enoughHours, std::ceil(most));
}

LayerStyle makeStyle(const SunByPlace& sun, const LegendChoice& choice) {
    const std::vector<ColourClass> classes = styleClasses(makeColourScale(sun, choice));
    return {"Hours of sun a day", graduatedStyle(StyledShape::polygons, "hours_mean", classes)};
}

}  // namespace noonmark
