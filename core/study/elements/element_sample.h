#pragma once

#include "core/study/elements/element_study.h"

namespace noonmark {

/// Measures a sample of the study's points by rays and compares. Points are taken at equal distances in the
/// list, beginning at a place that the seed chooses; as many as the settings ask for and as mostRays allows.
Result<ElementError> sampleElementError(const ElementStudy& study, Progress& progress,
                                        const std::stop_token& stop);

}  // namespace noonmark
