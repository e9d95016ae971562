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
        review,     ///< the sheets of the review, which have their own dialog
    };
    Subject subject = Subject::shown;
    bool withProject = false;  ///< a copy of the project's file beside the files, for `verify`
};

/// Makes the sheets of an export, on any thread. Null: they have no pages.
using MakeSheets = std::function<std::shared_ptr<const Book>()>;

}  // namespace noonmark
