#pragma once

#include <cstddef>
#include <string>

#include "core/study/study.h"

namespace noonmark {

/// The name of the region's polygon file that goes with a study whose region is no box.
constexpr const char* regionFileName = "region.geojson";

/// The noonmark-cli command line that gives the same result again, for a POSIX shell; files without their
/// folders. Settings that have their default value and do not belong to the question are left out. Lines
/// longer than `width` letters go on, after a backslash, on the next.
/// `command`: "study", or another that takes its options.
std::string repeatCommand(const Study& study, std::size_t width = 120, const std::string& command = "study");

}  // namespace noonmark
