#pragma once

#include "core/city/city.h"

namespace noonmark {

/// The city that the files of a comparison or a score need besides the answer. `city` must outlive this
/// object.
struct AnswerSource {
    const City& city;  ///< in a comparison: the city after the change
};

}  // namespace noonmark
