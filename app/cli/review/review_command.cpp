#include "app/cli/review/review_commands.h"

namespace noonmark::cli {

void addReviewCommand(CLI::App& app, Run& run) {
    CLI::App* review =
        app.add_subcommand("review", "Evaluate the rule of a review board on the places of a project");
    review->require_subcommand(1);
    addReviewList(*review, run);
    addReviewShow(*review, run);
    addReviewRun(*review, run);
}

}  // namespace noonmark::cli
