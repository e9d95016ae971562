#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "app/cli/base/console.h"
#include "app/cli/options/measure_options.h"
#include "app/cli/options/sheet_options.h"
#include "app/questions/question.h"

namespace noonmark::cli {

/// What a command on a project asks, and how it prints the answer.
struct Measure {
    const Question& question;
    std::string scenario;
    std::string baseline{};  ///< of a comparison
    std::function<Result<void>(const Project&, Asked&)>
        complete{};  ///< what else it asks for; empty: nothing
    /// The names of its files: provenance states the region.
    std::function<std::vector<std::string>(const Provenance&, bool withSheets)> fileNames;
    std::function<ChangeScale(const Project&)> scale{};  ///< of a comparison's picture
    void (*print)(const Answer&, std::ostream&);
};

/// Opens the project, asks, writes the files, saves the answer in the project if requested, and prints it.
/// Returns the exit code.
int runMeasure(const MeasureOptions& options, const SheetOptions& sheets, const Measure& measure,
               const Console& console);

}  // namespace noonmark::cli
