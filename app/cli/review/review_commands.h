#pragma once

#include "app/cli/base/command.h"

namespace noonmark::cli {

// The commands of `review`.
void addReviewList(CLI::App& review, Run& run);
void addReviewShow(CLI::App& review, Run& run);
void addReviewRun(CLI::App& review, Run& run);

}  // namespace noonmark::cli
