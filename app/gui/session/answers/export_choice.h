#pragma once

#include <functional>

#include "app/gui/session/answers/measured_answers.h"
#include "app/questions/answer.h"

namespace noonmark {

/// What an export writes, and how.
struct ExportChoice : AnswerFiles {
    ExportChoice() { cells = true; }

    enum class Subject {
        shown,      ///< the answer displayed
        place,      ///< what the buildings take from the place of the dock Contributions
        scenarios,  ///< the studies of all scenarios that were measured, side by side
        table,      ///< the table of scenarios: scores, verdicts and sun of places, also without studies
        view,       ///< the picture of the view
    };
    static constexpr int minHeight = 200, maxSide = 8192;  ///< of the view's picture, pixels
    int pictureHeight = 1000;                              ///< of that; its width is pictureWidth
    bool framed = true;                                    ///< with title, legend and scale bar
    Subject subject = Subject::shown;
    bool withProject = false;  ///< a copy of the project's file beside the files, for `verify`
    std::string sheetsName{};  ///< of the PDF with the sheets; empty: its standard name
};

/// What sheets are printed from: equal ones give the same pages.
struct PrintedFrom {
    std::shared_ptr<const Answer> answer;  ///< null: all scenarios
    std::string scenarios;                 ///< their figures
    std::optional<AnswerOrigin> origin;
    ChangeScale scale{};
    std::optional<double> thresholdHours{};
    BookSettings book{};
    std::vector<Region> regions{};
    bool operator==(const PrintedFrom&) const = default;
};

/// The sheets of an export.
struct SheetsToMake {
    PrintedFrom from{};
    /// Lays them out, on any thread. Null: there are none. Errors of Answer::layOut().
    std::function<Result<std::shared_ptr<const Book>>(Progress& progress, const std::stop_token& stop)> make;
};

}  // namespace noonmark
