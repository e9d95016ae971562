#pragma once

// File > Export. ExportDialog asks what to write (ExportChoice) and where; the workbench writes it.
// MovieDialog does the same for movies, which movie_export.h makes. CopyActions puts tables and pictures on
// the clipboard; table_text.h turns tables into text.

#include "app/report/book/paper.h"
#include "app/report/maps/change_scale.h"
#include "app/report/sheets/sheet.h"

namespace noonmark {

/// What an export writes.
struct ExportChoice {
    enum class Subject {
        shown,      ///< the result displayed
        scenarios,  ///< the studies of all scenarios that were measured, side by side
        review,     ///< the sheets of the review, which have their own dialog
    };
    Subject subject = Subject::shown;
    ChangeScale scale{};                        ///< of a comparison
    int pictureWidth = noonmark::pictureWidth;  ///< pixels
    bool cells = true;                          ///< of a study, a table of all cells
    bool sheets = false;                        ///< of a comparison or score, a book of sheets
    PageSetup setup{};                          ///< of sheets
};

}  // namespace noonmark
