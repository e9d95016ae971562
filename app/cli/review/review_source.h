#pragma once

#include "app/cli/review/review_run_options.h"
#include "app/questions/review_question.h"

namespace noonmark::cli {

/// Reads what the options name: a project on disk, or a city from files, which has the one scenario
/// "Existing". Error: a project with reading options, scenarios or places of city files, what the readers
/// refuse, cancelled().
Result<ReviewSource> openReviewSource(const ReviewRunOptions& options, const RuleLibrary& library,
                                      const Console& console);

/// What every review checks before it measures.
struct ReviewGround {
    ReviewedCities cities;
    std::string zone;
    int year = 2026;
    BookSettings sheets;
};

/// Error: no time zone, a scenario that does not exist, a file that may not be replaced, settings of sheets
/// out of range.
Result<ReviewGround> prepareGround(const ReviewRunOptions& options, const ReviewSource& source,
                                   const std::vector<std::string>& fileNames);

/// Writes the files of a review into the folder of the options. Returns their paths.
Result<std::vector<std::filesystem::path>> writeAnswer(const Answer& answer, const ReviewRunOptions& options,
                                                       const BookSettings& sheets, const ReviewSource& source,
                                                       const Console& console);

/// Prints the review.json that lies in the folder.
void printReviewJson(const std::filesystem::path& folder, std::ostream& out);

}  // namespace noonmark::cli
