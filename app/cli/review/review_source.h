#pragma once

#include "app/cli/review/review_run_options.h"
#include "app/input/load_city.h"
#include "app/report/book/book.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

/// What a review is run on: a project on disk, or a city read from files, which has the one scenario
/// "Existing".
struct ReviewSource {
    Project project;
    std::optional<ProjectFile> disk;   ///< none: city files
    std::optional<LoadedCity> loaded;  ///< none: a project
};

/// Reads what the options name. Error: a project with reading options, scenarios or places of city files,
/// what the readers refuse, cancelled().
Result<ReviewSource> openReviewSource(const ReviewRunOptions& options, const Console& console);

/// What every review checks before it measures.
struct ReviewGround {
    std::string from, to;  ///< names of baseline and scenario
    City before, after;
    std::string zone;
    int year = 2026;
    BookSettings sheets;
};

/// Error: no time zone, a scenario that does not exist, a file that may not be replaced, settings of sheets
/// out of range.
Result<ReviewGround> prepareGround(const ReviewRunOptions& options, const ReviewSource& source,
                                   const std::vector<std::string>& fileNames, const OutputRules& outputs);

/// What the cities of the review were made from.
Provenance provenanceOf(const ReviewSource& source, const ReviewGround& ground);

}  // namespace noonmark::cli
