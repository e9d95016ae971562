#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/base/console.h"
#include "app/cli/options/read_options.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/review/rule_options.h"
#include "app/input/output_rules.h"
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
