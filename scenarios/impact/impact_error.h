#pragma once

#include <stop_token>

#include "core/measures/error_sample.h"

namespace noonmark {

/// A city and the field that an engine computed for it.
struct CityField {
    const City& city;
    const ShadowField& field;
};

/// Measures how far the change between two cities by an engine differs from the change by the ray reference,
/// on a sample of the receivers common to both cities. It traces twice the rays of a study's error, so a
/// limited number of rays covers half as many receivers.
Result<SampledError> measureChangeError(const CityField& before, const CityField& after,
                                        const Receivers& receivers, const SunSteps& sun,
                                        const ErrorSampleSettings& settings, Progress& progress,
                                        const std::stop_token& stop);

}  // namespace noonmark
