#include "app/input/load_project.h"

#include "core/io/files/geopackage_check.h"
#include "scenarios/project/project_file.h"

namespace noonmark {

bool isProjectFile(const std::string& file) {
    return file.ends_with(projectEnding) || holdsProject(file).value_or(false);
}

LoadedCity loadProjectCity(const Project& project, const std::string& file) {
    LoadedCity loaded;
    loaded.files = {file};
    loaded.inputs = project.inputs;
    loaded.settings = project.reading->settings;
    loaded.read.city = *project.city;
    loaded.read.format = "Noonmark project";
    loaded.read.features = project.city->buildings.size();
    loaded.read.attribution = project.attribution;
    loaded.read.warnings = project.reading->warnings;
    loaded.read.heights = project.reading->heights;
    return loaded;
}

}  // namespace noonmark
