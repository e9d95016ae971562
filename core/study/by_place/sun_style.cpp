#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

ColourScale makeScale(const SunByPlace& sun, const PlaceColours& colours) {
    std::vector<double> hours;
    for (const SunOfPlace& of : sun.sun) hours.push_back(of.meanHours);
    return makeThresholdScale(colours.legend, colours.thresholdHours.value_or(sun.settings.enoughHours),
                              hours);
}

LayerStyle makeStyle(const SunByPlace& sun, const PlaceColours& colours) {
    const std::vector<ColourClass> classes = styleClasses(makeScale(sun, colours));
    return {"Hours of sun a day", graduatedStyle(StyledShape::polygons, "hours_mean", classes)};
}

}  // namespace noonmark
