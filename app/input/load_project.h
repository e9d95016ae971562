#pragma once

#include <string>

#include "app/input/load_city.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// Whether it is a project file, by its ending or by what it holds. Looks into databases only.
bool isProjectFile(const std::string& file);

/// The project's city as it stands, with what was noted when it was read from its files. `file`: the
/// project's.
LoadedCity loadedFrom(const Project& project, const std::string& file);

}  // namespace noonmark
