#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/console.h"
#include "app/cli/options/study_options.h"
#include "app/input/load_city.h"
#include "app/input/output_rules.h"

namespace noonmark::cli {

/// An error with the code that it ends the program with.
struct Failure {
    Error error;
    ExitCode code = exitFailed;
};

template <class T>
tl::expected<T, Failure> orCode(Result<T> result, ExitCode code) {
    return std::move(result).map_error([code](Error error) { return Failure{std::move(error), code}; });
}

/// What the options ask, of which city.
struct StudyRequest {
    LoadedCity loaded;
    StudySettings settings;
    std::optional<Provenance> provenance;  ///< of a project's scenario
};

Provenance provenanceOf(const StudyRequest& asked);

/// Adds what reading took and found, and what the city came from.
void addSource(Study& study, const StudyRequest& asked);

/// Reads the city and the region and tries the folder: all that can be wrong before the work begins. `files`:
/// the names of what will be written there, but for region.geojson.
tl::expected<StudyRequest, Failure> parseStudyRequest(const StudyOptions& options,
                                                      std::vector<std::string> files, Progress& progress,
                                                      const std::stop_token& stop);

/// What the outputs may be written over. `inputs`: what the city was read from, as far as it is known.
OutputRules outputRulesOf(const StudyOptions& options, const std::vector<InputFile>& inputs);

}  // namespace noonmark::cli
