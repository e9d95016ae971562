#include "app/report/maps/element_legend.h"

#include <algorithm>

namespace noonmark {

namespace {

double minutesOf(const MeasuredElement& element, ShadowMeasure measure) {
    return measure == ShadowMeasure::gross ? element.grossMin : element.continuousMin;
}

}  // namespace

Legend makeLegend(const ElementMap& map, ShadowMeasure measure, const LegendChoice& choice) {
    double top = map.possibleMin;
    std::vector<float> minutes;
    for (const MeasuredElement& element : map.elements) {
        minutes.push_back(float(minutesOf(element, measure)));
        top = std::max(top, minutesOf(element, measure));
    }
    return makeLegend(measure, choice, map.possibleMin, top, minutes);
}

Legend makeSunLegend(const ElementMap& map, const LegendChoice& choice) {
    const bool isSun = choice.show != ShownAs::shadow;
    return makeLegend(map, ShadowMeasure::gross,
                      isSun ? choice : showAs(choice, ShownAs::sun, map.possibleMin));
}

}  // namespace noonmark
