#pragma once

#include "app/input/load_city.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// Starts a project with a city: every building gets a unique id. The sample Central Park South includes the
/// park and the lots of its case study.
Project projectOf(const LoadedCity& loaded);

}  // namespace noonmark
