#pragma once

#include <stop_token>

#include "core/measures/error_sample.h"

namespace noonmark {

/// A city with the field that an engine found in it.
struct CityField {
    const City& city;
    const ShadowField& field;
};

/// How far the change that an engine finds between two cities is from the change that the ray reference
/// finds, on a sample of the receivers that both have. Twice the rays of a study's error, so on half as many
/// receivers where rays are short.
Result<SampledError> measureChangeError(const CityField& before, const CityField& after,
                                        const Receivers& receivers, const SunSteps& sun,
                                        const ErrorSampleSettings& settings, Progress& progress,
                                        const std::stop_token& stop);

}  // namespace noonmark
