#pragma once

#include <map>
#include <string>

#include "core/study/study.h"

namespace noonmark {

/// How long each file took to write, by its name, s. Files are written side by side.
using FileSeconds = std::map<std::string, double>;

/// studyJson() with the times of files that were written before it, as `write_seconds`.
std::string studyJson(const Study& study, const FileSeconds& writeSeconds);

}  // namespace noonmark
