#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/base/command_line.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/review/review_command.h"
#include "app/input/load_city.h"
#include "app/questions/review_question.h"
#include "core/study/elements/place_elements.h"
#include "core/study/review_study.h"

namespace noonmark {

struct ReviewSource;

namespace cli {

/// The windows that a rule is evaluated on.
struct GlazingRunOptions {
    ElementSettings elements;
    bool ofFile = false, onFacades = false;  ///< which of the two was asked for
    std::string region = "city";
    std::string engine = "auto";
    std::optional<double> wallM;   ///< thickness of the walls, instead of the rule's
    std::vector<double> sunshine;  ///< twelve probabilities, or empty
    [[nodiscard]] bool asked() const { return ofFile || onFacades; }
};

/// The options of `review run`, as given by the user.
struct ReviewRunOptions {
    RuleOptions rules;
    SheetOptions sheets;
    ReadOptions read;  ///< a project, or city files
    std::string rule, from, to, out;
    std::vector<std::string> places;
    ReviewSettings settings{1, {}, 0};
    GlazingRunOptions windows;
    bool overwrite = false;
    bool byteOrderMark = false;
    bool withProject = false;  ///< copy the project beside the files
    bool inReach = false;
    bool estimate = false;  ///< state the expected time instead of running
    bool json = false;
};

/// Adds --windows, --facades-of and what belongs to them.
void addGlazingRunOptions(CLI::App& command, GlazingRunOptions& windows);

/// Runs `review run` of a rule about windows: measures, writes the files and prints the counts, or
/// review.json. Returns the exit code.
int runGlazingReviews(const ReviewRunOptions& options, const Rule& rule, const ReviewSource& source,
                      const Console& console);

}  // namespace cli

}  // namespace noonmark

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
