#pragma once

#include "app/gui/session/project/view_state.h"
#include "app/gui/session/study/open_city.h"
#include "scenarios/project/project_file.h"

namespace noonmark {

/// A project and the city of one of its scenarios, ready for display.
struct OpenProject {
    Project project;
    std::optional<ProjectFile> file;  ///< none: never saved
    ViewState view;
    OpenCity city;  ///< the city of view.scenario
    /// Read from a recovery file of an earlier run.
    bool recovered = false;
    ZoneGuess zone;  ///< guessed from the city's location
    /// Of reading the places of a map, which are not repeated in the results of studies.
    Warnings placeWarnings;
};

/// Whether the files are a single project file, by its extension.
bool isProject(const std::vector<std::string>& files);

/// Reads a project, or city files as a project without a file; no widgets, for use in a job. If the scenario
/// of the view cannot be shown any more, the existing city is shown, with a warning.
Result<OpenProject> openProject(const std::vector<std::string>& files, const ReadSettings& settings,
                                Progress& progress, const std::stop_token& stop);

/// `loaded` with the buildings of `city`, for a scenario.
LoadedCity withCity(LoadedCity loaded, const City& city);

}  // namespace noonmark
