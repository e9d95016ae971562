#pragma once

#include "core/city/city.h"

namespace noonmark {

/// The box around the main body of the city: around all buildings but those whose middle lies, along one
/// axis, farther from the nine tenths in the middle than these are wide. One distant building moves the
/// middle of all buildings, but not that of their main body. Empty without buildings. O(n).
Box2 mainBounds(const City& city);

}  // namespace noonmark
