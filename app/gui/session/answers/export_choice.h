#pragma once

#include <functional>

#include "app/questions/answer.h"

namespace noonmark {

/// What an export writes, and how.
struct ExportChoice : AnswerFiles {
    ExportChoice() { cells = true; }

    enum class Subject {
        shown,      ///< the answer displayed
        place,      ///< what the buildings take from the place of the dock Contributions
        scenarios,  ///< the studies of all scenarios that were measured, side by side
    };
    Subject subject = Subject::shown;
    bool withProject = false;  ///< a copy of the project's file beside the files, for `verify`
};

/// Lays out the sheets of an export, on any thread. Null: there are none. Errors of Answer::layOut().
using MakeSheets =
    std::function<Result<std::shared_ptr<const Book>>(Progress& progress, const std::stop_token& stop)>;

}  // namespace noonmark
