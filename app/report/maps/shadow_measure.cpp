#include "app/report/maps/shadow_measure.h"

#include <algorithm>

#include "core/describe/text.h"

namespace noonmark {

const std::vector<float>& getValues(const ShadowField& field, ShadowMeasure measure) {
    return measure == ShadowMeasure::gross ? field.grossMin : field.continuousMin;
}

QString nameOf(ShadowMeasure measure) {
    return measure == ShadowMeasure::gross ? QStringLiteral(NM_TEXT("Gross shadow"))
                                           : QStringLiteral(NM_TEXT("Continuous shadow"));
}

QString describeMeasure(ShadowMeasure measure) {
    return measure == ShadowMeasure::gross ? QStringLiteral(NM_TEXT("minutes in shadow a day"))
                                           : QStringLiteral(NM_TEXT("longest run, minutes"));
}

double topOf(const ShadowField& field, ShadowMeasure measure) {
    double top = std::max(field.sunlitMinutesPerDay, 0.0);
    for (const float value : getValues(field, measure))
        if (double(value) > top) top = double(value);  // false for NaN
    return top;
}

}  // namespace noonmark
