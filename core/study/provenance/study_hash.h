#pragma once

#include <string>

#include "core/study/study.h"

namespace noonmark {

/// SHA-256 of a city's geometry, place and terrain, not of names and sources: equal where every shadow is
/// the same. Lower-case hex. O(points), some 0.1 s for 43,000 buildings.
std::string cityHash(const City& city);

/// SHA-256 of all that a result depends on: the version of the program, the city's geometry, place and
/// terrain, and the settings. Names, sources and the memory limit are not in it. Lower-case hex. O(points).
std::string studyHash(const City& city, const StudySettings& settings);

}  // namespace noonmark
