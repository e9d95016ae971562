#pragma once

#include "app/input/load_city.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// A project that begins with a city: every building gets an id of its own, and the sample Central Park South
/// brings the park and the lots of its case study along.
Project projectOf(const LoadedCity& loaded);

}  // namespace noonmark
