#pragma once

#include <string>
#include <vector>

#include "core/study/study.h"

namespace noonmark {

/// What the files of a comparison or a score say of the city that it is of. `city` outlives it.
struct AnswerSource {
    const City& city;  ///< of a comparison: the one after
    std::string attribution{};
    std::vector<InputFile> inputs{};
    ReadSettings reading{};
    Warnings warnings{};  ///< of reading the city
};

}  // namespace noonmark
