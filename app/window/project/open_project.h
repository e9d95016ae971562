#pragma once

#include "app/window/project/view_state.h"
#include "app/window/study/open_city.h"
#include "scenarios/project/project_file.h"

namespace noonmark {

/// A project with the city of one of its scenarios ready to be shown.
struct OpenProject {
    Project project;
    std::optional<ProjectFile> file;  ///< none: it was never saved
    ViewState view;
    OpenCity city;           ///< of view.scenario
    bool recovered = false;  ///< work that an earlier run left unsaved
    ZoneGuess zone;          ///< of the city
};

/// Whether the files are one project file, by its ending.
bool isProject(const std::vector<std::string>& files);

/// Everything that opening takes, without the window: for a job. City files become a project that has no
/// file. A scenario of the view that cannot be shown any more gives a warning, and the city as it stands.
Result<OpenProject> openProject(const std::vector<std::string>& files, const ReadSettings& settings,
                                Progress& progress, std::stop_token stop);

/// The same city as read, with other buildings: for a scenario.
LoadedCity withCity(LoadedCity loaded, const City& city);

}  // namespace noonmark
