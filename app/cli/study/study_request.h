#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/base/command_line.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/options/study_options.h"
#include "app/input/load_city.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

/// Whether one of the files is a project.
bool namesProject(const ReadOptions& options);

/// Error where a project is combined with other files or with reading options: the project states how its
/// city was read. Call it only if namesProject().
Result<void> checkProjectAlone(const ReadOptions& options);

/// Reads the city of a command with a progress line; Ctrl-C cancels. For a project it returns the existing
/// city.
Result<LoadedCity> loadCity(const ReadOptions& options, const Console& console);

/// An error and the exit code of the program.
struct Failure {
    Error error;
    ExitCode code = exitFailed;
};

template <class T>
tl::expected<T, Failure> orCode(Result<T> result, ExitCode code) {
    return std::move(result).map_error([code](Error error) { return Failure{std::move(error), code}; });
}

/// The settings and the city that the options ask for.
struct StudyRequest {
    LoadedCity loaded;
    StudySettings settings;
    ElementSettings elements;                      ///< with their parts
    std::optional<Provenance> provenance;          ///< for a scenario of a project
    std::shared_ptr<const ProjectFile> project{};  ///< that the city is of; null: of none
};

Provenance provenanceOf(const StudyRequest& request);

/// Units and title block of its project; those of none where it has no project.
SheetSettings sheetsOf(const StudyRequest& request);

/// Puts a request's project beside the files where --with-project asks for it. Error: copyProject()'s.
Result<void> copyProjectOf(const std::shared_ptr<const ProjectFile>& project, const StudyOptions& options);

/// Adds the time and warnings of reading, and the provenance of the city.
void addSource(Study& study, const StudyRequest& request);

/// Reads the city and the region and checks the output folder, so that all errors in the input appear before
/// the computation. `files`: names of the output files, except region.geojson.
tl::expected<StudyRequest, Failure> parseStudyRequest(const StudyOptions& options,
                                                      std::vector<std::string> files, Progress& progress,
                                                      const std::stop_token& stop);

/// Which files the outputs may replace. `inputs`: the files from which the city was read, as far as known.
OutputRules outputRulesOf(const StudyOptions& options, const std::vector<InputFile>& inputs);

}  // namespace noonmark::cli
