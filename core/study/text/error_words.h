#pragma once

#include <string>
#include <vector>

#include "core/study/study.h"

namespace noonmark {

/// A row of a table: a name, and a value with its unit.
struct ErrorLine {
    std::string name;
    std::string value;
};

/// The study's error against the ray reference, for display: the error of the area, of the cells, and the
/// sample; or one row that says why there is none.
std::vector<ErrorLine> makeErrorLines(const Study& study);

/// Why a study has no measured error, as a sentence; empty if it has one.
std::string whyNoError(const Study& study);

}  // namespace noonmark
