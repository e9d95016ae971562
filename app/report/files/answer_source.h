#pragma once

#include "core/city/city.h"

namespace noonmark {

/// What the files of a comparison or a score need beside the answer: the city that it is of. `city` outlives
/// it.
struct AnswerSource {
    const City& city;  ///< of a comparison: the one after
};

}  // namespace noonmark
