#pragma once

#include <string>

#include "app/input/load_city.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// Whether the file is a project, by its ending or its content. Reads only files that are databases.
bool isProjectFile(const std::string& file);

/// The project's existing city, with the warnings of reading its files. `file`: the path of the project.
LoadedCity loadProjectCity(const Project& project, const std::string& file);

/// Starts a project with a city: every building gets a unique id. The sample Central Park South includes the
/// park and the lots of its case study.
Project projectOf(const LoadedCity& loaded);

}  // namespace noonmark
