#pragma once

#include <string>
#include <vector>

#include "core/study/study.h"

namespace noonmark {

/// A line of a table: what, and its value with unit.
struct ErrorLine {
    std::string name;
    std::string value;
};

/// The study's error against the ray reference, for people: of the area, of the cells, and what it was
/// measured on; or one line that says why there is none.
std::vector<ErrorLine> errorLines(const Study& study);

/// Why a study has no measured error, a whole sentence; empty where it has one.
std::string whyNoError(const Study& study);

}  // namespace noonmark
